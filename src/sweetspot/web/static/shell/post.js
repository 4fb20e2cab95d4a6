// Questions to the API.

// What the server answers. One that cannot be reached is a refusal, marked as lost.
/** @param {string} path @param {RequestInit} [question] @returns {Promise<Response>} */
export async function asked(path, question) {
  try {
    return await fetch(path, question);
  } catch (error) {
    if (question?.signal?.aborted) throw error;
    throw { field: "", message: "The server does not answer; try again once it does.", lost: true };
  }
}

// POST JSON; a refusal is thrown as {field, message}.

/** @param {string} path @param {object} table */
export async function posted(path, table) {
  const response = await asked(path, {
    method: "POST", headers: { "content-type": "application/json" }, body: JSON.stringify(table),
  });
  const answer = await response.json();
  if (!response.ok) throw answer.error ?? { field: "", message: "there is nothing of that kind for this view" };
  return answer;
}

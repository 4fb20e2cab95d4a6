// Questions to the API.

const WAIT = 429; // status of an answer to one of many behind this address: to be asked again after a while

// What the server answers; where it says to wait, it is asked again then. One that cannot be reached is a refusal, marked
// as lost.
/**
 * @param {string} path
 * @param {RequestInit} [question]
 * @returns {Promise<Response>}
 */
export async function asked(path, question) {
  let response;
  try {
    response = await fetch(path, question);
  } catch (error) {
    if (question?.signal?.aborted) throw error;
    throw { field: "", message: "The server does not answer; try again once it does.", lost: true };
  }
  if (response.status !== WAIT) return response;
  await new Promise((done) => setTimeout(done, 1000 * Number(response.headers.get("retry-after"))));
  return asked(path, question);
}

// POST JSON; a refusal is thrown as {field, message}.

/**
 * @param {string} path
 * @param {object} table
 */
export async function posted(path, table) {
  const response = await asked(path, {
    method: "POST", headers: { "content-type": "application/json" }, body: JSON.stringify(table),
  });
  const answer = await response.json();
  if (!response.ok) throw answer.error ?? { field: "", message: "there is nothing of that kind for this view" };
  return answer;
}

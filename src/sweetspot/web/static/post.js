// POST JSON to the API; a refusal is thrown as {field, message}.

/**
 * @param {string} path
 * @param {object} table
 */
export async function posted(path, table) {
  const response = await fetch(path, {
    method: "POST", headers: { "content-type": "application/json" }, body: JSON.stringify(table),
  });
  const answer = await response.json();
  if (!response.ok) throw answer.error ?? { field: "", message: "there is nothing of that kind for this view" };
  return answer;
}

package org.dfra.app.doctor;

/** What is thought of a finding. */
enum Verdict {
  /** As it should be. */
  OK,
  /** It works, but not in every circumstance. */
  WARN,
  /** Something does not work. */
  FAIL
}

package org.dfra.app.doctor;

/** The severity of a finding. */
enum Verdict {
  /** As expected. */
  OK,
  /** It works, but not under all conditions. */
  WARN,
  /** It does not work. */
  FAIL
}

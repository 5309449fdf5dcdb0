package org.dfra.river.phoenix;

/**
 * How a process exited.
 *
 * @param description the rest of a sentence that begins with the group's name
 * @param isRequested whether an orderly exit was requested; the daemon itself does not request it
 *     by a signal
 */
record ProcessExit(String description, boolean isRequested) {

  /** Exit code of a virtual machine that SIGTERM shut down: 128 and the signal's number. */
  private static final int TERMINATED = 143;

  static ProcessExit unrequested(String how) {
    return new ProcessExit(how, false);
  }

  static ProcessExit of(int exitCode) {
    return new ProcessExit("ended (exit code " + exitCode + ")", exitCode == TERMINATED);
  }
}

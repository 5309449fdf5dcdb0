package org.dfra.river.phoenix;

/**
 * How a process ended.
 *
 * @param description the rest of a sentence that begins with the group's name
 * @param isRequested whether somebody asked for an orderly end; the daemon itself does not do so by
 *     a signal
 */
record ProcessExit(String description, boolean isRequested) {

  /** Of a virtual machine whose shutdown was begun by SIGTERM: 128 and the signal's number. */
  private static final int TERMINATED = 143;

  static ProcessExit unrequested(String how) {
    return new ProcessExit(how, false);
  }

  static ProcessExit of(int exitCode) {
    return new ProcessExit("ended (exit code " + exitCode + ")", exitCode == TERMINATED);
  }
}

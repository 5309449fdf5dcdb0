package org.dfra.app.terminal;

/** A command that cannot go on: one sentence for the user, and the status to end with. */
public final class CommandFailure extends RuntimeException {

  private static final long serialVersionUID = 1L;

  private final int exitCode;

  /**
   * @param exitCode one of {@link ExitCode}
   * @param sentence what is wrong, where, and what to do
   */
  public CommandFailure(int exitCode, String sentence) {
    super(sentence);
    this.exitCode = exitCode;
  }

  public CommandFailure(int exitCode, String sentence, Throwable cause) {
    super(sentence, cause);
    this.exitCode = exitCode;
  }

  /** The status to end with. */
  public int exitCode() {
    return exitCode;
  }
}

package org.dfra.report.terminal;

/** The exit statuses of {@code ./dfra}. They never change their meaning. */
public final class ExitCode {

  /** Success. */
  public static final int SUCCESS = 0;

  /** The request failed. */
  public static final int FAILED = 1;

  /** A usage error: an unknown subcommand, option or value. */
  public static final int USAGE_ERROR = 2;

  /** There is no such robot or module, or none matches the query. */
  public static final int NOT_FOUND = 3;

  /** The module or phoenix is known but did not answer in time. */
  public static final int NO_ANSWER = 4;

  /** The command is in a module that is not installed; the script's own status for that. */
  public static final int NOT_INSTALLED = 69;

  private ExitCode() {}
}

package org.dfra.app.terminal;

/** The statuses with which {@code ./dfra} ends. They never change their meaning. */
public final class ExitCode {

  /** All went well. */
  public static final int SUCCESS = 0;

  /** What was asked could not be done. */
  public static final int FAILED = 1;

  /** It was asked wrongly: an unknown verb, option or value. */
  public static final int USAGE_ERROR = 2;

  /** There is no such robot or module, or nothing answers the query. */
  public static final int NOT_FOUND = 3;

  /** The module or phoenix is known but did not answer in time. */
  public static final int NO_ANSWER = 4;

  private ExitCode() {}
}

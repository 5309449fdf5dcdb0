package org.dfra.app.log;

import ch.qos.logback.classic.spi.IThrowableProxy;
import ch.qos.logback.classic.spi.StackTraceElementProxy;
import ch.qos.logback.classic.spi.ThrowableProxy;
import org.dfra.text.Printable;
import org.jspecify.annotations.Nullable;

/**
 * An exception with its stack trace and causes, in Logback's form, with each message and frame
 * {@linkplain Printable printable} and on one line. An exception that came from another computer
 * has messages and frames of that computer's choice.
 */
public final class PrintableTrace {

  private static final String END = System.lineSeparator();

  private PrintableTrace() {}

  /** Its lines, each with its end. */
  public static String of(Throwable thrown) {
    StringBuilder text = new StringBuilder();
    append(text, new ThrowableProxy(thrown));
    return text.toString();
  }

  /** Appends its lines, each with its end. */
  static void append(StringBuilder text, IThrowableProxy thrown) {
    append(text, thrown, "", 1);
  }

  /**
   * @param indent tabulators before each of its frames
   */
  private static void append(
      StringBuilder text, IThrowableProxy thrown, String relation, int indent) {
    String what = Printable.line(thrown.getClassName() + ": " + thrown.getMessage());
    text.append("\t".repeat(indent - 1)).append(relation);
    text.append(thrown.isCyclic() ? "[CIRCULAR REFERENCE: " + what + "]" : what).append(END);
    String margin = "\t".repeat(indent);
    StackTraceElementProxy[] frames = thrown.getStackTraceElementProxyArray();
    for (int i = 0; i < frames.length - thrown.getCommonFrames(); i++) {
      text.append(margin).append(Printable.line(frames[i].toString())).append(END);
    }
    if (thrown.getCommonFrames() > 0) {
      text.append(margin).append("... ").append(thrown.getCommonFrames());
      text.append(" common frames omitted").append(END);
    }
    for (IThrowableProxy suppressed : thrown.getSuppressed()) {
      append(text, suppressed, "Suppressed: ", indent + 1);
    }
    @Nullable IThrowableProxy cause = thrown.getCause();
    if (cause != null) {
      append(text, cause, "Caused by: ", indent);
    }
  }
}

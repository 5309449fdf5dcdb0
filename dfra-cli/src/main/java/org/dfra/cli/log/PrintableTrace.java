package org.dfra.cli.log;

import ch.qos.logback.classic.spi.IThrowableProxy;
import ch.qos.logback.classic.spi.StackTraceElementProxy;
import ch.qos.logback.classic.spi.ThrowableProxy;
import org.dfra.text.PrintableText;
import org.jspecify.annotations.Nullable;

/**
 * An exception with its stack trace and causes, in Logback's form, with each message and frame
 * {@linkplain PrintableText printable} and on one line. Another computer chooses the messages and
 * the number of frames of its exceptions: at most {@value #MOST_LINES} lines are kept.
 */
public final class PrintableTrace {

  /** Maximum lines of one exception; those of a JVM have at most 1024 frames each. */
  static final int MOST_LINES = 4096;

  private static final String END = System.lineSeparator();

  private final StringBuilder text;
  private int lines;

  private PrintableTrace(StringBuilder text) {
    this.text = text;
  }

  /** Its lines, each with its line end. */
  public static String of(Throwable thrown) {
    StringBuilder text = new StringBuilder();
    append(text, new ThrowableProxy(thrown));
    return text.toString();
  }

  /** Appends its lines, each with its line end. */
  static void append(StringBuilder text, IThrowableProxy thrown) {
    PrintableTrace trace = new PrintableTrace(text);
    trace.append(thrown, "", 1);
    int omitted = trace.lines - MOST_LINES;
    if (omitted > 0) {
      text.append("... ").append(omitted).append(" more lines omitted").append(END);
    }
  }

  /** Adds a line, or only counts it after the maximum. */
  private void line(String margin, String content) {
    if (lines++ < MOST_LINES) {
      text.append(margin).append(content).append(END);
    }
  }

  /**
   * @param indent tab characters before each of its frames
   */
  private void append(IThrowableProxy thrown, String relation, int indent) {
    String what = PrintableText.line(thrown.getClassName() + ": " + thrown.getMessage());
    line(
        "\t".repeat(indent - 1),
        relation + (thrown.isCyclic() ? "[CIRCULAR REFERENCE: " + what + "]" : what));
    String margin = "\t".repeat(indent);
    StackTraceElementProxy[] frames = thrown.getStackTraceElementProxyArray();
    for (int i = 0; i < frames.length - thrown.getCommonFrames(); i++) {
      line(margin, lines < MOST_LINES ? PrintableText.line(frames[i].toString()) : "");
    }
    if (thrown.getCommonFrames() > 0) {
      line(margin, "... " + thrown.getCommonFrames() + " common frames omitted");
    }
    for (IThrowableProxy suppressed : thrown.getSuppressed()) {
      append(suppressed, "Suppressed: ", indent + 1);
    }
    @Nullable IThrowableProxy cause = thrown.getCause();
    if (cause != null) {
      append(cause, "Caused by: ", indent);
    }
  }
}

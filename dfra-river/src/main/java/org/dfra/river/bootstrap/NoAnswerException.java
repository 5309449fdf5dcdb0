package org.dfra.river.bootstrap;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.Locale;
import org.dfra.core.host.CommandName;

/** A remote call was repeated without an answer until the command's deadline. */
public final class NoAnswerException extends RemoteException {

  private static final long serialVersionUID = 1L;

  private final String sentence;

  /**
   * @param asked the remote object that did not answer, in words
   * @param time the duration of the attempts
   * @param last the failure of the last call
   */
  public NoAnswerException(String asked, Duration time, Throwable last) {
    super("", last);
    this.sentence =
        asked
            + " did not answer within "
            + seconds(time)
            + " s ("
            + reason(last)
            + "); see whether its process hangs or the computer is overloaded: "
            + CommandName.current()
            + " doctor";
  }

  private static String seconds(Duration time) {
    return time.toMillis() % 1000 == 0
        ? Long.toString(time.toSeconds())
        : String.format(Locale.ROOT, "%.1f", time.toMillis() / 1e3);
  }

  /** A clause: remote exceptions append advice, and their causes on lines of their own. */
  private static String reason(Throwable failure) {
    String message = failure.getMessage() == null ? failure.toString() : failure.getMessage();
    return message.lines().findFirst().orElse("").replaceFirst(";.*", "").strip();
  }

  /** {@inheritDoc} One sentence, without the failure that is its cause. */
  @Override
  public String getMessage() {
    return sentence;
  }
}

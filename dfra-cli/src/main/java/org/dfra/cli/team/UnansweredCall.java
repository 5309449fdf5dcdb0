package org.dfra.cli.team;

import java.rmi.RemoteException;
import org.dfra.module.NotReadyException;
import org.dfra.report.terminal.CommandFailure;
import org.jspecify.annotations.Nullable;

/**
 * Describes a module that gave no answer, so that the others can still be listed. Its proxy is code
 * of its own robot, and may fail in any way.
 */
public final class UnansweredCall {

  private UnansweredCall() {}

  /**
   * A clause of one line.
   *
   * @param path the module's path, {@code robot/name}
   * @param failure of its call
   */
  public static String inWords(String path, Throwable failure) {
    if (failure instanceof CommandFailure) {
      return String.valueOf(failure.getMessage()); // which contains its name
    }
    boolean isSilent = failure instanceof RemoteException || failure instanceof NotReadyException;
    return path
        + (isSilent
            ? " does not answer: " + firstLine(failure.getMessage())
            : " cannot be asked, since its proxy failed: " + firstLine(failure.toString()));
  }

  private static String firstLine(@Nullable String text) {
    return String.valueOf(text).lines().findFirst().orElse("").strip();
  }
}

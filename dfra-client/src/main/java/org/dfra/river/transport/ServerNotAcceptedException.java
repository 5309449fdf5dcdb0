package org.dfra.river.transport;

import java.io.IOException;
import java.util.Optional;

/**
 * A server was reached, and it and this program do not accept each other: one of them has joined no
 * team, they are of different teams, or a certificate is not believed. Nothing was sent that the
 * server could execute.
 */
public final class ServerNotAcceptedException extends IOException {

  private static final long serialVersionUID = 1L;

  ServerNotAcceptedException(String message) {
    super(message);
  }

  ServerNotAcceptedException(String message, Throwable cause) {
    super(message, cause);
  }

  /** Whether it is among the causes of a failure. */
  public static boolean isCauseOf(Throwable failure) {
    return reason(failure).isPresent();
  }

  /** Its message, if it is among the causes of a failure. */
  public static Optional<String> reason(Throwable failure) {
    for (Throwable at = failure; at != null; at = at.getCause()) {
      if (at instanceof ServerNotAcceptedException) {
        return Optional.ofNullable(at.getMessage());
      }
    }
    return Optional.empty();
  }
}

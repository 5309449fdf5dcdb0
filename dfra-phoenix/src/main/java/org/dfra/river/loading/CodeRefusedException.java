package org.dfra.river.loading;

import org.jspecify.annotations.Nullable;

/** Code was not loaded: the message names the codebase, the reason and the remedy. */
public final class CodeRefusedException extends SecurityException {

  private static final long serialVersionUID = 1L;

  CodeRefusedException(String message) {
    this(message, null);
  }

  CodeRefusedException(String message, @Nullable Throwable cause) {
    super(message, cause);
  }
}

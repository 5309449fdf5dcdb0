package org.dfra.river.filter;

/**
 * A graph was refused before it was built. It is the cause of the {@link
 * java.io.InvalidClassException} that the reader gets.
 */
public final class RefusedDataException extends SecurityException {

  private static final long serialVersionUID = 1L;

  RefusedDataException(String message) {
    super(message);
  }
}

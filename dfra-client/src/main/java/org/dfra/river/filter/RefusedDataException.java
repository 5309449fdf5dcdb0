package org.dfra.river.filter;

/**
 * An object graph was refused before it was deserialized. It is the cause of the {@link
 * java.io.InvalidClassException} that the reader gets.
 */
public final class RefusedDataException extends SecurityException {

  private static final long serialVersionUID = 1L;

  RefusedDataException(String message) {
    super(message);
  }
}

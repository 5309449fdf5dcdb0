package org.dfra.core.config;

import java.io.Serializable;

/**
 * A place in a configuration file, for error messages.
 *
 * @param file the file, as named to the reader; {@code code} for values given in code
 * @param line the line in it, the first is 1; 0 for the file as a whole
 */
public record SourceLocation(String file, int line) implements Serializable {

  /** The place of values given in code, for tests and examples. */
  public static final SourceLocation CODE = new SourceLocation("code", 0);

  public SourceLocation {
    if (file.isBlank()) {
      throw new IllegalArgumentException("a place names no file");
    }
    if (line < 0) {
      throw new IllegalArgumentException("line " + line + " of " + file + " is below 0");
    }
  }

  /** {@code file:line}, or {@code file} for the file as a whole. */
  @Override
  public String toString() {
    return line == 0 ? file : file + ":" + line;
  }
}

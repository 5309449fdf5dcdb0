package org.dfra.core.config;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;

/** A file that a description is read from. */
public final class SourceFile {

  private SourceFile() {}

  /**
   * The content of a file.
   *
   * @param what it should be, for the error message, such as {@code the XML file of a robot}
   * @throws ConfigurationException if it does not exist or cannot be read
   */
  public static byte[] readBytes(Path file, String what) {
    try {
      return Files.readAllBytes(file);
    } catch (NoSuchFileException e) {
      throw new ConfigurationException(file + ": there is no such file; name " + what, e);
    } catch (IOException e) {
      throw new ConfigurationException(
          file + ": the file cannot be read (" + e + "); name a readable file", e);
    }
  }
}

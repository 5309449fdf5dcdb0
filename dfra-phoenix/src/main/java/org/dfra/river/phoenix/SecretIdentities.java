package org.dfra.river.phoenix;

import java.io.IOException;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Properties;
import java.util.UUID;
import net.jini.id.Uuid;
import org.dfra.core.host.PrivateFiles;
import org.jspecify.annotations.Nullable;

/**
 * The identities that only phoenix's user knows. Phoenix generates them at random at its first
 * start with a folder, and stores them there.
 *
 * @param system of the activation system
 * @param monitor of the monitor
 */
record SecretIdentities(Uuid system, Uuid monitor) {

  private static final String SYSTEM = "system";
  private static final String MONITOR = "monitor";

  /** Generates random identities. */
  static SecretIdentities fresh() {
    return new SecretIdentities(
        PhoenixIdentities.uuid(UUID.randomUUID()), PhoenixIdentities.uuid(UUID.randomUUID()));
  }

  /**
   * Returns the identities of a folder; creates them if there are none.
   *
   * @param folder of the journal; created if missing
   * @throws IOException if other users may enter the folder, or the identities cannot be stored
   */
  static SecretIdentities in(Path folder) throws IOException {
    Path file = folder.resolve(PhoenixIdentities.FILE);
    try {
      PrivateFiles.requireFolderOrParent(folder);
      try {
        return readPrivate(file);
      } catch (NoSuchFileException e) {
        SecretIdentities drawn = fresh();
        String text = SYSTEM + "=" + drawn.system + "\n" + MONITOR + "=" + drawn.monitor + "\n";
        return PrivateFiles.writeNew(file, text) ? drawn : readPrivate(file);
      }
    } catch (FileSystemException e) {
      throw new IOException(
          "the identity file "
              + file
              + " cannot be made or read ("
              + (e.getReason() == null ? e.toString() : e.getReason())
              + "); free space or correct the folder's permissions",
          e);
    }
  }

  private static SecretIdentities readPrivate(Path file) throws IOException {
    SecretIdentities read = read(file);
    PrivateFiles.requireFile(file);
    return read;
  }

  /**
   * Reads a file of identities.
   *
   * @throws NoSuchFileException if there is none
   * @throws java.nio.file.AccessDeniedException if it belongs to another user
   * @throws IOException if it cannot be read or parsed
   */
  static SecretIdentities read(Path file) throws IOException {
    Properties lines = new Properties();
    try {
      lines.load(new StringReader(Files.readString(file, StandardCharsets.UTF_8)));
      return new SecretIdentities(
          identity(lines.getProperty(SYSTEM)), identity(lines.getProperty(MONITOR)));
    } catch (IllegalArgumentException e) {
      throw new IOException(
          "the identity file "
              + file
              + " is damaged; end phoenix and its groups, delete it, and bring the robots up again",
          e);
    }
  }

  private static Uuid identity(@Nullable String text) {
    if (text == null) {
      throw new IllegalArgumentException("a line is missing");
    }
    return PhoenixIdentities.uuid(text);
  }

  /** Omits the secrets, since the text may be logged. */
  @Override
  public String toString() {
    return "secret identities";
  }
}

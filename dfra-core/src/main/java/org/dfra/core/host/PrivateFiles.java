package org.dfra.core.host;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFileAttributes;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.nio.file.attribute.UserPrincipal;
import java.util.EnumSet;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * Files and folders that only the user of this process may read, write and enter: mode 0600 for
 * files, 0700 for folders. What is made here has its mode from the start, so there is no moment at
 * which others could open it.
 *
 * <p>A file in a private folder is out of reach of other users, whatever its own mode.
 */
public final class PrivateFiles {

  /** Modes of all users but the owner. */
  private static final Set<PosixFilePermission> OTHERS =
      EnumSet.of(
          PosixFilePermission.GROUP_READ,
          PosixFilePermission.GROUP_WRITE,
          PosixFilePermission.GROUP_EXECUTE,
          PosixFilePermission.OTHERS_READ,
          PosixFilePermission.OTHERS_WRITE,
          PosixFilePermission.OTHERS_EXECUTE);

  private static final Set<PosixFilePermission> FILE = PosixFilePermissions.fromString("rw-------");
  private static final Set<PosixFilePermission> FOLDER =
      PosixFilePermissions.fromString("rwx------");

  private PrivateFiles() {}

  /**
   * Makes a private folder, and the folders it is in where they are missing. Nothing happens where
   * there is a folder already, whatever its mode.
   */
  public static void makeFolder(Path folder) throws IOException {
    if (!Files.isDirectory(folder)) { // createDirectories of JDK 17 refuses a link to a folder
      Files.createDirectories(folder, PosixFilePermissions.asFileAttribute(FOLDER));
    }
  }

  /**
   * Makes a private folder where it is missing, and refuses one that is not private.
   *
   * @throws IOException if other users may enter it, with the command that mends that, or if it
   *     belongs to another user or cannot be made
   */
  public static void requireFolder(Path folder) throws IOException {
    makeFolder(folder);
    @Nullable String fault = privacyFault(folder);
    if (fault != null) {
      throw new IOException(fault);
    }
  }

  /**
   * As {@link #requireFolder}, but a folder that is directly in a private one may have any mode:
   * other users cannot reach it.
   */
  public static void requireFolderOrParent(Path folder) throws IOException {
    makeFolder(folder);
    @Nullable String fault = privacyFault(folder);
    if (fault == null) {
      return;
    }
    @Nullable Path parent = folder.toAbsolutePath().normalize().getParent();
    if (parent == null || privacyFault(parent) != null) {
      throw new IOException(fault);
    }
  }

  /**
   * What keeps a folder from being private, and what to do, in a sentence; null if it is private.
   *
   * @throws IOException if it does not exist or its mode cannot be read
   */
  public static @Nullable String privacyFault(Path folder) throws IOException {
    PosixFileAttributes attributes = attributes(folder);
    UserPrincipal user = user();
    if (!attributes.owner().equals(user)) {
      return "the folder "
          + folder
          + " belongs to user "
          + attributes.owner().getName()
          + " and not to "
          + user.getName()
          + "; run this as that user, or name a folder of your own";
    }
    return isOpen(attributes)
        ? "other users may enter the folder "
            + folder
            + " ("
            + PosixFilePermissions.toString(attributes.permissions())
            + "), which must be private; type: chmod 700 "
            + shell(folder)
        : null;
  }

  /**
   * Refuses a file that is not this user's own, or that other users may read or write.
   *
   * @throws IOException if it is not private, with what mends that, or does not exist
   */
  public static void requireFile(Path file) throws IOException {
    PosixFileAttributes attributes = attributes(file);
    if (!attributes.owner().equals(user())) {
      throw new IOException(
          "the file " + file + " belongs to user " + attributes.owner().getName());
    }
    if (isOpen(attributes)) {
      throw new IOException(
          "other users may use the file "
              + file
              + " ("
              + PosixFilePermissions.toString(attributes.permissions())
              + "), which must be private; type: chmod 600 "
              + shell(file));
    }
  }

  private static boolean isOpen(PosixFileAttributes attributes) {
    return attributes.permissions().stream().anyMatch(OTHERS::contains);
  }

  private static PosixFileAttributes attributes(Path path) throws IOException {
    try {
      return Files.readAttributes(path, PosixFileAttributes.class);
    } catch (UnsupportedOperationException e) {
      throw new IOException(
          "the file system of " + path + " keeps no owners and modes; name a folder on another", e);
    }
  }

  /** Makes an empty private file. Nothing happens where there is one, whatever its mode. */
  public static void makeFile(Path file) throws IOException {
    if (!Files.exists(file)) {
      try {
        Files.createFile(file, privateFile());
      } catch (FileAlreadyExistsException e) {
        return; // made by another process since it was looked for
      }
    }
  }

  /**
   * Makes a private file with a text, whole and safe on disk.
   *
   * @return false, with nothing changed, if there is such a file already
   */
  public static boolean writeNew(Path file, String text) throws IOException {
    Path draft =
        Files.createTempFile(
            file.toAbsolutePath().getParent(), "." + file.getFileName(), ".draft", privateFile());
    try {
      Files.writeString(draft, text, StandardCharsets.UTF_8);
      try (FileChannel written = FileChannel.open(draft, StandardOpenOption.WRITE)) {
        written.force(true);
      }
      Files.createLink(file, draft); // fails where there is a file; a move would replace it
      return true;
    } catch (FileAlreadyExistsException e) {
      return false;
    } finally {
      Files.deleteIfExists(draft);
    }
  }

  /** Takes the rights of other users from a file of this user's. */
  public static void closeToOthers(Path file) throws IOException {
    Files.setPosixFilePermissions(file, FILE);
  }

  /** The mode of a private file, for calls that make one. */
  public static FileAttribute<Set<PosixFilePermission>> privateFile() {
    return PosixFilePermissions.asFileAttribute(FILE);
  }

  /** The user that this process runs as. */
  public static UserPrincipal user() throws IOException {
    Path self = Path.of("/proc/self");
    return Files.exists(self)
        ? Files.getOwner(self)
        : FileSystems.getDefault()
            .getUserPrincipalLookupService()
            .lookupPrincipalByName(System.getProperty("user.name"));
  }

  /** The name of the user whose path it is, or else the nearest folder above it that is seen. */
  public static String ownerName(Path path) {
    return Stream.iterate(path.toAbsolutePath(), Objects::nonNull, Path::getParent)
        .flatMap(each -> owner(each).stream())
        .findFirst()
        .orElse("unknown");
  }

  private static Optional<String> owner(Path path) {
    try {
      return Optional.of(Files.getOwner(path).getName());
    } catch (IOException e) {
      return Optional.empty(); // it does not exist, or is in a folder that this user may not enter
    }
  }

  /** A path as a shell takes it. */
  private static String shell(Path path) {
    String text = path.toString();
    return text.matches("[A-Za-z0-9_./+:@%,-]+") ? text : "'" + text.replace("'", "'\\''") + "'";
  }
}

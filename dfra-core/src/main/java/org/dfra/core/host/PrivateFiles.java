package org.dfra.core.host;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
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
 * files, 0700 for folders. Files are created with this mode, so other users can never open them.
 *
 * <p>A file in a private folder is not accessible to other users, whatever its own mode.
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
   * Creates a private folder, and missing parent folders. Does nothing if the folder exists,
   * whatever its mode.
   */
  public static void makeFolder(Path folder) throws IOException {
    if (!Files.isDirectory(folder)) { // createDirectories of JDK 17 refuses a link to a folder
      Files.createDirectories(folder, PosixFilePermissions.asFileAttribute(FOLDER));
    }
  }

  /**
   * Creates a private folder if it is missing, and refuses one that is not private.
   *
   * @throws IOException if other users may enter it, with the command that corrects this, or if it
   *     belongs to another user or cannot be created
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
   * Why a folder is not private, and the remedy, in a sentence; null if it is private.
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
   * @throws IOException if it is not private, with the command that corrects this, or does not
   *     exist
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

  /** Creates an empty private file. Does nothing if it exists, whatever its mode. */
  public static void makeFile(Path file) throws IOException {
    if (!Files.exists(file)) {
      try {
        Files.createFile(file, privateFile());
      } catch (FileAlreadyExistsException e) {
        return; // created by another process since the check
      }
    }
  }

  /**
   * Creates a private file with a text, atomically and synced to disk.
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
      Files.createLink(file, draft); // fails if the file exists; a move would replace it
      return true;
    } catch (FileAlreadyExistsException e) {
      return false;
    } finally {
      Files.deleteIfExists(draft);
    }
  }

  /**
   * Writes a private file, atomically and synced to disk: after a failure of the computer it has
   * either its former content or the new one.
   */
  public static void write(Path file, byte[] content) throws IOException {
    Path folder = Objects.requireNonNull(file.toAbsolutePath().getParent(), "a file has a folder");
    Path draft = Files.createTempFile(folder, "." + file.getFileName(), ".draft", privateFile());
    try {
      Files.write(draft, content);
      sync(draft);
      Path unused = Files.move(draft, file, StandardCopyOption.ATOMIC_MOVE);
    } finally {
      Files.deleteIfExists(draft);
    }
    sync(folder);
  }

  /** Has a file, or the names in a folder, written to disk. */
  public static void sync(Path path) throws IOException {
    try (FileChannel channel = FileChannel.open(path, StandardOpenOption.READ)) {
      channel.force(true);
    }
  }

  /** Removes the permissions of other users from a file of this user. */
  public static void closeToOthers(Path file) throws IOException {
    Files.setPosixFilePermissions(file, FILE);
  }

  /** The mode of a private file, for calls that create one. */
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

  /** The owner of a path, or else of the nearest accessible parent folder. */
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

  /** A path quoted for a shell. */
  private static String shell(Path path) {
    String text = path.toString();
    return text.matches("[A-Za-z0-9_./+:@%,-]+") ? text : "'" + text.replace("'", "'\\''") + "'";
  }
}

package org.dfra.river.transport.local;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.file.DirectoryStream;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributes;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.time.Instant;
import java.util.Set;
import net.jini.id.Uuid;
import org.jspecify.annotations.Nullable;

/**
 * The folder of this user's Unix-domain sockets, which nobody else may enter: {@code dfra-}user in
 * the folder of the system property {@value #PROPERTY}, or else in {@code /tmp}, since paths of
 * sockets must be short.
 */
public final class SocketFolder {

  private static final System.Logger LOG = System.getLogger(SocketFolder.class.getName());

  private static final String PROPERTY = "dfra.transport.sockets";
  private static final Duration SETTLED = Duration.ofSeconds(10);
  private static final String DEFAULT = "/tmp";
  private static final Set<PosixFilePermission> OWNER_ONLY =
      PosixFilePermissions.fromString("rwx------");

  private SocketFolder() {}

  /**
   * Listens on a new socket in it.
   *
   * @param server names the file
   * @return null if this operating system or folder has no such sockets
   */
  public static @Nullable ServerSocketChannel listen(Uuid server, int backlog) {
    if (ComputerId.OWN.isEmpty()) {
      return null;
    }
    try {
      Path file = folder().resolve(server + ".sock");
      if (file.toString().length() > LocalSocket.MAX_PATH_BYTES) {
        throw new IOException(
            "the path "
                + file
                + " is too long for a socket; set "
                + PROPERTY
                + " to a shorter one");
      }
      ServerSocketChannel channel = ServerSocketChannel.open(StandardProtocolFamily.UNIX);
      try {
        channel.bind(UnixDomainSocketAddress.of(file), backlog);
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-------"));
        file.toFile().deleteOnExit();
        return channel;
      } catch (IOException e) {
        channel.close();
        throw e;
      }
    } catch (IOException | UnsupportedOperationException e) {
      LOG.log(Level.INFO, "No local socket, so programs on this computer connect by TCP: " + e);
      return null;
    }
  }

  /** The path of a listening socket. */
  public static String path(ServerSocketChannel channel) throws IOException {
    return String.valueOf(channel.getLocalAddress());
  }

  /** Deletes the file of a socket that was listened on. */
  public static void delete(String path) {
    try {
      Files.deleteIfExists(Path.of(path));
    } catch (IOException e) {
      LOG.log(Level.DEBUG, "A socket was not deleted.", e);
    }
  }

  private static synchronized Path folder() throws IOException {
    String user = Files.getOwner(Path.of("/proc/self")).getName();
    Path folder = Path.of(System.getProperty(PROPERTY, DEFAULT), "dfra-" + user);
    try {
      Files.createDirectory(folder, PosixFilePermissions.asFileAttribute(OWNER_ONLY));
    } catch (FileAlreadyExistsException e) {
      PosixFileAttributes its =
          Files.readAttributes(folder, PosixFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
      boolean isOwn = its.isDirectory() && its.owner().getName().equals(user);
      if (!isOwn || !its.permissions().equals(OWNER_ONLY)) {
        throw new IOException(
            folder
                + " is no folder that only "
                + user
                + " may enter; delete it or set "
                + PROPERTY
                + " to another place",
            e);
      }
      deleteAbandoned(folder);
    }
    return folder;
  }

  private static boolean isNew(Path file) throws IOException {
    try {
      Instant made = Files.getLastModifiedTime(file, LinkOption.NOFOLLOW_LINKS).toInstant();
      return made.isAfter(Instant.now().minus(SETTLED));
    } catch (NoSuchFileException e) { // deleted meanwhile
      return true;
    }
  }

  /** Deletes the sockets of processes that were killed: nobody listens. */
  private static void deleteAbandoned(Path folder) throws IOException {
    try (DirectoryStream<Path> sockets = Files.newDirectoryStream(folder, "*.sock")) {
      for (Path each : sockets) {
        if (isNew(each)) {
          continue; // its process may be about to listen
        }
        try (SocketChannel channel = SocketChannel.open(StandardProtocolFamily.UNIX)) {
          channel.configureBlocking(false); // a suspended process may accept no connection
          channel.connect(UnixDomainSocketAddress.of(each));
        } catch (java.net.ConnectException e) {
          Files.deleteIfExists(each);
        } catch (IOException e) {
          LOG.log(Level.DEBUG, "Whether anybody listens on " + each + " is unknown.", e);
        }
      }
    }
  }
}

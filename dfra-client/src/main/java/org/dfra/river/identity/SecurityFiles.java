package org.dfra.river.identity;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;

/**
 * The files in the folder of an identity, {@code security} in the state folder, and how they are
 * read: each has a largest size, and files with keys and passphrases must be private.
 */
public final class SecurityFiles {

  /** The folder's name in the state folder. */
  public static final String FOLDER = "security";

  /** The member's key and certificates, in PKCS #12. */
  public static final String IDENTITY = "identity.p12";

  /** The passphrase of {@link #IDENTITY}: one line of text. */
  public static final String IDENTITY_PASSPHRASE = "identity.pass";

  /** A robot's key between its own processes, in PKCS #12. */
  public static final String ROBOT = "robot.p12";

  /** The passphrase of {@link #ROBOT}: one line of text. */
  public static final String ROBOT_PASSPHRASE = "robot.pass";

  /** The certificate of the team's authority, in PEM. */
  public static final String AUTHORITY = "authority.pem";

  /** The authority's list of revoked certificates: an X.509 CRL in DER or PEM. */
  public static final String REVOKED = "revoked.crl";

  /** The team's policy. */
  public static final String POLICY = "policy.xml";

  /** The authority's signature over the bytes of {@link #POLICY}, in Base64. */
  public static final String POLICY_SIGNATURE = "policy.sig";

  /** The latest time that the robot's processes know of, as an instant of ISO 8601. */
  public static final String LATEST_TIME = "latest-time";

  /** A JAAS configuration of the user's own; it may be missing. */
  public static final String JAAS = "jaas.conf";

  /** Name of the entry in {@link #IDENTITY}. */
  public static final String IDENTITY_ALIAS = "identity";

  /** Name of the entry in {@link #ROBOT}. */
  public static final String ROBOT_ALIAS = "robot";

  private static final int MAX_BYTES = 256 * 1024;

  /** A certificate that is revoked takes about 40 bytes. */
  private static final int MAX_REVOKED_BYTES = 4 * 1024 * 1024;

  private static final Set<PosixFilePermission> OTHERS =
      EnumSet.complementOf(
          EnumSet.of(
              PosixFilePermission.OWNER_READ,
              PosixFilePermission.OWNER_WRITE,
              PosixFilePermission.OWNER_EXECUTE));

  private SecurityFiles() {}

  /** The largest size of a file, in bytes. */
  public static int maxBytes(String name) {
    return name.equals(REVOKED) ? MAX_REVOKED_BYTES : MAX_BYTES;
  }

  /**
   * Reads a file that must exist.
   *
   * @throws IdentityException if it is missing, unreadable or too large
   */
  public static byte[] read(Path file) throws IdentityException {
    return readIfThere(file)
        .orElseThrow(
            () ->
                new IdentityException(
                    file + " is missing; join the team again: security join NAME.bundle"));
  }

  /**
   * Reads a file.
   *
   * @return empty if it does not exist
   * @throws IdentityException if it is unreadable or too large
   */
  static Optional<byte[]> readIfThere(Path file) throws IdentityException {
    int most = maxBytes(String.valueOf(file.getFileName()));
    try (InputStream in = Files.newInputStream(file)) {
      byte[] bytes = in.readNBytes(most + 1);
      if (bytes.length > most) {
        throw new IdentityException(
            file
                + " has more than "
                + most
                + " bytes, so it is not what its name says; join the team again: security join"
                + " NAME.bundle");
      }
      return Optional.of(bytes);
    } catch (NoSuchFileException e) {
      return Optional.empty();
    } catch (IOException e) {
      throw new IdentityException(
          file
              + " cannot be read ("
              + e
              + "); run this as the user that joined the team, or correct the file's owner",
          e);
    }
  }

  /**
   * Refuses a file or folder that other users may read or write.
   *
   * @throws IdentityException if it is not private, with the command that corrects this
   */
  static void requirePrivate(Path file) throws IdentityException {
    String right = Files.isDirectory(file) ? "700 " : "600 ";
    try {
      Set<PosixFilePermission> mode = Files.getPosixFilePermissions(file);
      if (mode.stream().anyMatch(OTHERS::contains)) {
        throw new IdentityException(
            "other users may use "
                + file
                + " ("
                + PosixFilePermissions.toString(mode)
                + "), which must be private; type: chmod "
                + right
                + file);
      }
    } catch (UnsupportedOperationException e) {
      throw new IdentityException(
          "the file system of " + file + " keeps no modes; use a state folder on another one", e);
    } catch (IOException e) {
      throw new IdentityException(
          "the mode of " + file + " cannot be read (" + e + "); correct the folder's owner", e);
    }
  }
}

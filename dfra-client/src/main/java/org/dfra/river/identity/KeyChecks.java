package org.dfra.river.identity;

import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.InvalidKeyException;
import java.security.PrivateKey;
import java.security.Signature;
import java.security.SignatureException;
import java.security.cert.X509Certificate;
import java.util.Optional;
import javax.naming.InvalidNameException;
import javax.naming.ldap.LdapName;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;

/** Checks of private keys against their certificates. */
public final class KeyChecks {

  private static final String AGAIN = "; join the team again: security join NAME.bundle";
  private static final String ROBOT_KEY = " robot key";
  private static final String UNKNOWN_TEAM = "unknown";

  private KeyChecks() {}

  /**
   * Checks that a key is that of a certificate.
   *
   * @throws IdentityException if it is not
   */
  public static void requireMatch(PrivateKey key, X509Certificate certificate, String file)
      throws IdentityException {
    byte[] text = file.getBytes(StandardCharsets.UTF_8);
    try {
      Signature signer = Signature.getInstance("SHA256withECDSA");
      signer.initSign(key);
      signer.update(text);
      byte[] signature = signer.sign();
      signer.initVerify(certificate.getPublicKey());
      signer.update(text);
      if (signer.verify(signature)) {
        return;
      }
    } catch (InvalidKeyException | SignatureException e) {
      throw new IdentityException(
          "the key in " + file + " is no key of an elliptic curve (" + e + ")" + AGAIN, e);
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("every JDK has ECDSA", e);
    }
    throw new IdentityException(
        "the key in " + file + " does not belong to the certificate beside it" + AGAIN);
  }

  /**
   * Checks a robot's key for its own processes.
   *
   * @param robot whose it must be
   * @throws IdentityException if it belongs to another robot, or key and certificate differ
   */
  public static void requireRobotKey(TeamCredentials.RobotKey robotKey, Member robot, String file)
      throws IdentityException {
    X509Certificate certificate = robotKey.certificate();
    requireMatch(robotKey.key(), certificate, file);
    String wanted = "CN=" + robot.name() + ROBOT_KEY;
    String found = certificate.getSubjectX500Principal().getName();
    if (!found.equals(wanted)) {
      throw new IdentityException(
          "the key in " + file + " is that of " + found + ", not of " + wanted + AGAIN);
    }
    try {
      certificate.verify(certificate.getPublicKey());
    } catch (GeneralSecurityException e) {
      throw new IdentityException(
          "the certificate in " + file + " is not signed by its own key (" + e + ")" + AGAIN, e);
    }
  }

  /**
   * The robot that its own key names, in the team of an authority.
   *
   * @param authority of the team; the key's own certificate if it is not known
   * @param file of the key, for messages
   */
  static Member robot(TeamCredentials.RobotKey key, X509Certificate authority, String file)
      throws IdentityException {
    String name = part(key.certificate(), "CN").orElse("");
    if (!name.endsWith(ROBOT_KEY)) {
      throw new IdentityException("the key in " + file + " names no robot" + AGAIN);
    }
    try {
      Member robot =
          new Member(
              part(authority, "O").orElse(UNKNOWN_TEAM),
              MemberRole.ROBOT,
              name.substring(0, name.length() - ROBOT_KEY.length()));
      requireRobotKey(key, robot, file);
      return robot;
    } catch (IllegalArgumentException e) {
      throw new IdentityException("the key in " + file + ": " + e.getMessage() + AGAIN, e);
    }
  }

  private static Optional<String> part(X509Certificate certificate, String type) {
    try {
      return new LdapName(certificate.getSubjectX500Principal().getName())
          .getRdns().stream()
              .filter(each -> each.getType().equalsIgnoreCase(type))
              .map(each -> String.valueOf(each.getValue()))
              .findFirst();
    } catch (InvalidNameException e) {
      return Optional.empty();
    }
  }
}

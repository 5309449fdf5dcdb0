package org.dfra.core.audit;

import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.InvalidKeyException;
import java.security.NoSuchAlgorithmException;
import java.security.PrivateKey;
import java.security.Signature;
import java.security.SignatureException;
import java.security.cert.X509Certificate;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Base64;
import java.util.regex.Pattern;

/**
 * The signed end of a stream. A member that keeps it can show later that lines were cut off or
 * changed since.
 *
 * @param stream name of the stream
 * @param number of its last line, at least 1
 * @param hash of that line, 64 hexadecimal digits
 * @param time when it was signed, milliseconds
 * @param signature SHA256withECDSA over the other components, in Base64
 */
public record AuditHead(String stream, long number, String hash, Instant time, String signature) {

  private static final String ALGORITHM = "SHA256withECDSA";

  /** So that nothing else that the same key signs can be taken for a head. */
  private static final String PURPOSE = "DFRA audit head 1";

  private static final Pattern STREAM = Pattern.compile(AuditSettings.STREAM);
  private static final Pattern HASH = Pattern.compile("[0-9a-f]{64}");
  private static final Pattern SIGNATURE = Pattern.compile("[A-Za-z0-9+/]{1,200}={0,2}");

  /**
   * Checks the form of its parts, but not the signature.
   *
   * @throws IllegalArgumentException if one cannot be a part of a head
   */
  public AuditHead {
    time = time.truncatedTo(ChronoUnit.MILLIS);
    if (!STREAM.matcher(stream).matches()
        || number < 1
        || !HASH.matcher(hash).matches()
        || !SIGNATURE.matcher(signature).matches()) {
      throw new IllegalArgumentException(
          "no head of an audit trail: its stream, number, hash or signature has another form");
    }
  }

  static AuditHead sign(String stream, long number, String hash, Instant time, PrivateKey key) {
    Instant when = time.truncatedTo(ChronoUnit.MILLIS);
    try {
      Signature signature = Signature.getInstance(ALGORITHM);
      signature.initSign(key);
      signature.update(content(stream, number, hash, when));
      String text = Base64.getEncoder().encodeToString(signature.sign());
      return new AuditHead(stream, number, hash, when, text);
    } catch (InvalidKeyException e) {
      throw new IllegalArgumentException(
          "the head of the audit trail " + stream + " needs a private key for ECDSA", e);
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("every Java has " + ALGORITHM, e);
    }
  }

  /**
   * Whether the holder of a certificate's key has signed it. The certificate itself is not checked:
   * that it is of this team, and was valid.
   */
  public boolean verify(X509Certificate certificate) {
    try {
      Signature check = Signature.getInstance(ALGORITHM);
      check.initVerify(certificate);
      check.update(content(stream, number, hash, time));
      return check.verify(Base64.getDecoder().decode(signature));
    } catch (InvalidKeyException | SignatureException | IllegalArgumentException e) {
      return false; // a key or a signature of another kind
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java has " + ALGORITHM, e);
    }
  }

  private static byte[] content(String stream, long number, String hash, Instant time) {
    return String.join("\n", PURPOSE, stream, Long.toString(number), hash, LineEncoder.time(time))
        .getBytes(StandardCharsets.UTF_8);
  }
}

package org.dfra.river.identity;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.PrivateKey;
import java.security.Signature;
import java.security.cert.CertificateFactory;
import java.security.cert.X509Certificate;
import java.time.DateTimeException;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Base64;
import java.util.List;
import java.util.regex.Pattern;
import org.dfra.river.access.CallCredential;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;

/**
 * A member's statement that another member may act on its behalf: who, with which robots, and until
 * when. It is signed with the first one's key, and names the certificate of the other one, so it is
 * of no use to a third. Calls carry it as their {@link CallCredential}.
 *
 * <p>It is a text of at most {@value CallCredential#MAX_BYTES} bytes in ASCII, whose lines have
 * this order:
 *
 * <pre>
 *   DFRA delegation 1
 *   from: operator anna of field
 *   to: robot atrv1 of field
 *   bearer: 64 hexadecimal digits, SHA-256 of the other one's certificate
 *   robots: atrv2,atrv3
 *   issued: 2026-11-29T02:00:00Z
 *   until: 2026-11-29T04:00:00Z
 *   certificate: of the first one, in Base64
 *   signature: of all bytes before this line by SHA256withECDSA, in Base64
 * </pre>
 *
 * @param principal on whose behalf
 * @param bearer who may act
 * @param fingerprint SHA-256 of the bearer's certificate, in hexadecimal digits
 * @param robots names of the robots that may be commanded
 * @param issued when it was signed
 * @param until its last instant
 * @param certificate of the principal
 * @param text what calls carry
 */
public record Delegation(
    Member principal,
    Member bearer,
    String fingerprint,
    List<String> robots,
    Instant issued,
    Instant until,
    X509Certificate certificate,
    String text) {

  /** The longest time for which somebody may act for another one. */
  public static final Duration LONGEST = Duration.ofHours(24);

  /** What a fingerprint is. */
  public static final Pattern FINGERPRINT = Pattern.compile("[0-9a-f]{64}");

  /** The most robots that one names. */
  public static final int MAX_ROBOTS = 16;

  private static final String TITLE = "DFRA delegation 1";
  private static final String ALGORITHM = "SHA256withECDSA";

  /** Copies the list. */
  public Delegation {
    robots = List.copyOf(robots);
  }

  /**
   * Signs one.
   *
   * @param principal whose key it is
   * @param until at most {@link #LONGEST} after {@code issued}
   * @throws IllegalArgumentException if it would be refused everywhere; the message says why
   */
  public static Delegation sign(
      TeamCredentials principal,
      Member bearer,
      String fingerprint,
      List<String> robots,
      Instant issued,
      Instant until) {
    return sign(
        principal.member(),
        principal.privateKey(),
        principal.certificate(),
        bearer,
        fingerprint,
        robots,
        issued,
        until);
  }

  /** As the other one, with a key that need not be in a folder. */
  public static Delegation sign(
      Member principal,
      PrivateKey key,
      X509Certificate certificate,
      Member bearer,
      String fingerprint,
      List<String> robots,
      Instant issued,
      Instant until) {
    Instant from = issued.truncatedTo(ChronoUnit.SECONDS);
    Instant to = until.truncatedTo(ChronoUnit.SECONDS);
    try {
      new Delegation(principal, bearer, fingerprint, robots, from, to, certificate, "")
          .requireForm();
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException("this cannot be delegated: " + e.getMessage(), e);
    }
    try {
      String signed =
          String.join(
              "\n",
              TITLE,
              "from: " + principal,
              "to: " + bearer,
              "bearer: " + fingerprint,
              "robots: " + String.join(",", robots),
              "issued: " + from,
              "until: " + to,
              "certificate: " + Base64.getEncoder().encodeToString(certificate.getEncoded()),
              "");
      Signature signer = Signature.getInstance(ALGORITHM);
      signer.initSign(key);
      signer.update(signed.getBytes(StandardCharsets.US_ASCII));
      String text =
          signed + "signature: " + Base64.getEncoder().encodeToString(signer.sign()) + "\n";
      return parse(text.getBytes(StandardCharsets.US_ASCII), "the delegation");
    } catch (GeneralSecurityException e) {
      throw new IllegalArgumentException("the key of " + principal + " cannot sign: " + e, e);
    } catch (IdentityException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  /**
   * Reads one and checks its signature by the certificate in it. Whether that certificate is one of
   * the team's authority, and is valid, is not checked.
   *
   * @param name of it, for messages
   * @throws IdentityException if it is none, or was changed
   */
  public static Delegation parse(byte[] bytes, String name) throws IdentityException {
    if (bytes.length > CallCredential.MAX_BYTES) {
      throw new IdentityException(
          name + " has " + bytes.length + " bytes > " + CallCredential.MAX_BYTES + " allowed");
    }
    String text = new String(bytes, StandardCharsets.US_ASCII);
    Lines lines = new Lines(text, name);
    if (!lines.next().equals(TITLE)) {
      throw new IdentityException(name + " does not begin with \"" + TITLE + "\"");
    }
    try {
      Member principal = member(lines.value("from"));
      Member bearer = member(lines.value("to"));
      String fingerprint = lines.value("bearer");
      List<String> robots = List.of(lines.value("robots").split(",", -1));
      Instant issued = Instant.parse(lines.value("issued"));
      Instant until = Instant.parse(lines.value("until"));
      X509Certificate certificate = certificate(lines.value("certificate"));
      int signedLength = lines.position();
      byte[] signature = decoded(lines.value("signature"));
      lines.requireEnd();
      Delegation read =
          new Delegation(principal, bearer, fingerprint, robots, issued, until, certificate, text);
      read.requireForm();
      Signature verifier = Signature.getInstance(ALGORITHM);
      verifier.initVerify(certificate);
      verifier.update(bytes, 0, signedLength);
      if (!verifier.verify(signature)) {
        throw new IdentityException(name + " was changed: its signature is of another text");
      }
      return read;
    } catch (GeneralSecurityException | IllegalArgumentException | DateTimeException e) {
      throw new IdentityException(name + " is no delegation (" + e.getMessage() + ")", e);
    }
  }

  /** What its fields must be, no matter who has signed it. */
  private void requireForm() {
    Member named = Member.of(certificate.getSubjectX500Principal());
    if (!named.equals(principal)) {
      throw new IllegalArgumentException("it is from " + principal + ", with the key of " + named);
    }
    if (principal.role() != MemberRole.OPERATOR) {
      throw new IllegalArgumentException("only operators delegate, and it is from " + principal);
    }
    if (bearer.role() == MemberRole.OPERATOR) {
      throw new IllegalArgumentException(
          "it is to " + bearer + ", and operators command for themselves");
    }
    if (!bearer.team().equals(principal.team())) {
      throw new IllegalArgumentException("it is from " + principal + " to " + bearer);
    }
    if (!FINGERPRINT.matcher(fingerprint).matches()) {
      throw new IllegalArgumentException("the bearer's fingerprint is no SHA-256");
    }
    if (robots.size() > MAX_ROBOTS) {
      throw new IllegalArgumentException(robots.size() + " robots > " + MAX_ROBOTS + " allowed");
    }
    for (String each : robots) {
      Member unused = new Member(principal.team(), MemberRole.ROBOT, each); // checks the name
    }
    Duration length = Duration.between(issued, until);
    if (length.isNegative() || length.isZero() || length.compareTo(LONGEST) > 0) {
      throw new IllegalArgumentException(
          "it lasts from " + issued + " until " + until + "; at most 24 h are allowed");
    }
  }

  private static Member member(String text) {
    String[] words = text.split(" ", -1);
    if (words.length != 4 || !words[2].equals("of")) {
      throw new IllegalArgumentException("\"" + text + "\" names no member");
    }
    return new Member(words[3], MemberRole.of(words[0]), words[1]);
  }

  private static X509Certificate certificate(String base64) throws GeneralSecurityException {
    return (X509Certificate)
        CertificateFactory.getInstance("X.509")
            .generateCertificate(new ByteArrayInputStream(decoded(base64)));
  }

  /** Bytes in Base64 in the one way in which {@link #sign} writes them. */
  private static byte[] decoded(String base64) {
    byte[] bytes = Base64.getDecoder().decode(base64);
    if (!Base64.getEncoder().encodeToString(bytes).equals(base64)) { // bits that nothing needs
      throw new IllegalArgumentException("the end of a text in Base64 was changed");
    }
    return bytes;
  }

  /** The fingerprint of a certificate as delegations write it. */
  public static String fingerprint(X509Certificate certificate) {
    return CertificateFingerprint.sha256(certificate)
        .replace(":", "")
        .toLowerCase(java.util.Locale.ROOT);
  }

  /** What calls carry. */
  public byte[] bytes() {
    return text.getBytes(StandardCharsets.US_ASCII);
  }

  /** As in sentences: from whom to whom. */
  @Override
  public String toString() {
    return "delegation of " + principal + " to " + bearer;
  }

  /** The lines of a text, in their order. */
  private static final class Lines {

    private final String text;
    private final String name;
    private int position;

    Lines(String text, String name) {
      this.text = text;
      this.name = name;
    }

    String next() throws IdentityException {
      int end = text.indexOf('\n', position);
      if (end < 0) {
        throw new IdentityException(name + " is no delegation, or its end is missing");
      }
      String line = text.substring(position, end);
      position = end + 1;
      return line;
    }

    String value(String field) throws IdentityException {
      String line = next();
      if (!line.startsWith(field + ": ")) {
        throw new IdentityException(
            name + " is no delegation: it has no \"" + field + "\" in its place");
      }
      return line.substring(field.length() + 2);
    }

    int position() {
      return position;
    }

    void requireEnd() throws IdentityException {
      if (position != text.length()) {
        throw new IdentityException(name + " has further text after its signature");
      }
    }
  }
}

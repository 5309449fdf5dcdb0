package org.dfra.authority;

import java.io.IOException;
import java.math.BigInteger;
import java.security.GeneralSecurityException;
import java.security.KeyPair;
import java.security.KeyPairGenerator;
import java.security.PrivateKey;
import java.security.SecureRandom;
import java.security.cert.X509Certificate;
import java.security.spec.ECGenParameterSpec;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Date;
import java.util.List;
import javax.security.auth.x500.X500Principal;
import org.bouncycastle.asn1.x509.BasicConstraints;
import org.bouncycastle.asn1.x509.ExtendedKeyUsage;
import org.bouncycastle.asn1.x509.Extension;
import org.bouncycastle.asn1.x509.KeyPurposeId;
import org.bouncycastle.asn1.x509.KeyUsage;
import org.bouncycastle.cert.jcajce.JcaX509CertificateConverter;
import org.bouncycastle.cert.jcajce.JcaX509ExtensionUtils;
import org.bouncycastle.cert.jcajce.JcaX509v3CertificateBuilder;
import org.bouncycastle.operator.OperatorCreationException;
import org.bouncycastle.operator.jcajce.JcaContentSignerBuilder;
import org.dfra.river.identity.KeyEntry;

/**
 * Makes certificates in the profile of RFC 5280: keys on the curve P-256, signatures by ECDSA with
 * SHA-256, serial numbers of 127 random bits.
 */
final class CertificateSigner {

  static final String SIGNATURE = "SHA256withECDSA";

  private static final String CURVE = "secp256r1";
  private static final int SERIAL_BITS = 127; // RFC 5280, 4.1.2.2: positive, at most 20 octets
  private static final int AUTHORITY_DAYS = 20 * 365;

  /** RFC 5280, 4.1.2.5: of a certificate without a well-defined end. */
  private static final Instant NO_END = Instant.parse("9999-12-31T23:59:59Z");

  /** Certificates are valid a little earlier, since clocks of computers differ. */
  private static final Duration CLOCK_DIFFERENCE = Duration.ofMinutes(5);

  private final SecureRandom random = new SecureRandom();

  /** What a certificate is to be. */
  private record Request(
      X500Principal subject,
      KeyPair key,
      Instant from,
      Instant until,
      BasicConstraints constraints,
      int usage,
      KeyPurposeId... purposes) {}

  /** A new authority of a team: self-signed, for certificates of members and lists. */
  KeyEntry authority(String team, Instant now) {
    X500Principal subject = new X500Principal("CN=" + team + " authority,O=" + team);
    KeyPair key = newKey();
    Request request =
        new Request(
            subject,
            key,
            begin(now),
            now.truncatedTo(ChronoUnit.SECONDS).plus(Duration.ofDays(AUTHORITY_DAYS)),
            new BasicConstraints(0), // it signs members, and no other authority
            KeyUsage.keyCertSign | KeyUsage.cRLSign);
    return new KeyEntry(key.getPrivate(), List.of(selfSigned(request)));
  }

  /** A new key with a certificate for both ends of connections. */
  KeyEntry member(KeyEntry authority, X500Principal subject, Instant now, Duration validity) {
    return issued(
        authority,
        subject,
        now,
        validity,
        KeyPurposeId.id_kp_serverAuth,
        KeyPurposeId.id_kp_clientAuth);
  }

  /** A new key with a certificate for signatures of code, and for nothing else. */
  KeyEntry code(KeyEntry authority, X500Principal subject, Instant now, Duration validity) {
    return issued(authority, subject, now, validity, KeyPurposeId.id_kp_codeSigning);
  }

  /** A new key of a robot for calls between its own processes: self-signed, without an end. */
  KeyEntry robotKey(String robot) {
    X500Principal subject = new X500Principal("CN=" + robot + " robot key");
    KeyPair key = newKey();
    Request request =
        new Request(
            subject,
            key,
            Instant.EPOCH, // a robot without a clock begins there
            NO_END,
            new BasicConstraints(false),
            KeyUsage.digitalSignature);
    return new KeyEntry(key.getPrivate(), List.of(selfSigned(request)));
  }

  private KeyEntry issued(
      KeyEntry authority,
      X500Principal subject,
      Instant now,
      Duration validity,
      KeyPurposeId... purposes) {
    X509Certificate issuer = authority.chain().get(0);
    KeyPair key = newKey();
    Instant until = now.truncatedTo(ChronoUnit.SECONDS).plus(validity);
    Instant last = issuer.getNotAfter().toInstant();
    Request request =
        new Request(
            subject,
            key,
            begin(now),
            until.isBefore(last) ? until : last,
            new BasicConstraints(false),
            KeyUsage.digitalSignature,
            purposes);
    X509Certificate certificate = signed(request, issuer, authority.key());
    return new KeyEntry(key.getPrivate(), List.of(certificate, issuer));
  }

  private static Instant begin(Instant now) {
    return now.truncatedTo(ChronoUnit.SECONDS).minus(CLOCK_DIFFERENCE);
  }

  private X509Certificate selfSigned(Request request) {
    return signed(request, null, request.key().getPrivate());
  }

  private X509Certificate signed(
      Request request, @org.jspecify.annotations.Nullable X509Certificate issuer, PrivateKey key) {
    JcaX509v3CertificateBuilder builder =
        new JcaX509v3CertificateBuilder(
            issuer == null ? request.subject() : issuer.getSubjectX500Principal(),
            serial(),
            Date.from(request.from()),
            Date.from(request.until()),
            request.subject(),
            request.key().getPublic());
    try {
      JcaX509ExtensionUtils identifiers = new JcaX509ExtensionUtils();
      builder.addExtension(Extension.basicConstraints, true, request.constraints());
      builder.addExtension(Extension.keyUsage, true, new KeyUsage(request.usage()));
      if (request.purposes().length > 0) {
        builder.addExtension(
            Extension.extendedKeyUsage, false, new ExtendedKeyUsage(request.purposes()));
      }
      builder.addExtension(
          Extension.subjectKeyIdentifier,
          false,
          identifiers.createSubjectKeyIdentifier(request.key().getPublic()));
      builder.addExtension(
          Extension.authorityKeyIdentifier,
          false,
          identifiers.createAuthorityKeyIdentifier(
              issuer == null ? request.key().getPublic() : issuer.getPublicKey()));
      return new JcaX509CertificateConverter()
          .getCertificate(builder.build(new JcaContentSignerBuilder(SIGNATURE).build(key)));
    } catch (GeneralSecurityException | IOException | OperatorCreationException e) {
      throw new IllegalStateException("every JDK signs by ECDSA", e);
    }
  }

  private BigInteger serial() {
    return new BigInteger(SERIAL_BITS, random).setBit(SERIAL_BITS - 1);
  }

  private KeyPair newKey() {
    try {
      KeyPairGenerator generator = KeyPairGenerator.getInstance("EC");
      generator.initialize(new ECGenParameterSpec(CURVE), random);
      return generator.generateKeyPair();
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("every JDK has the curve P-256", e);
    }
  }
}

package org.dfra.authority;

import java.io.IOException;
import java.math.BigInteger;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.cert.X509CRL;
import java.security.cert.X509CRLEntry;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.dfra.core.host.PrivateFiles;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.KeyEntry;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.river.identity.SignedFiles;

/**
 * The authority's list of revoked certificates, and its number. The next number is written before
 * the list that has it, so no two lists ever have the same one, also if the computer fails between.
 */
final class RevocationList {

  /** File with the number of the last list, in decimal digits. */
  static final String NUMBER = "revoked.number";

  private final Path folder;
  private final KeyEntry authority;

  RevocationList(Path folder, KeyEntry authority) {
    this.folder = folder;
    this.authority = authority;
  }

  /** The present list, in DER. */
  byte[] bytes() throws IOException {
    return Files.readAllBytes(file());
  }

  /** Its number. */
  BigInteger number() throws IOException {
    return SignedFiles.number(read()).orElseThrow();
  }

  /**
   * Writes a list with the next number, unless the present one has the same certificates.
   *
   * @param all that the authority has issued
   */
  void update(List<IssuedCertificate> all, Instant now) throws IOException {
    List<IssuedCertificate> revoked =
        all.stream().filter(each -> each.revokedAt().isPresent()).toList();
    if (Files.exists(file()) && serials(revoked).equals(serials(read()))) {
      return;
    }
    BigInteger next = last().add(BigInteger.ONE);
    PrivateFiles.write(folder.resolve(NUMBER), (next + "\n").getBytes(StandardCharsets.US_ASCII));
    PrivateFiles.write(file(), AuthoritySignatures.revocations(authority, next, revoked, now));
  }

  private static Set<BigInteger> serials(List<IssuedCertificate> revoked) {
    return revoked.stream().map(IssuedCertificate::serialNumber).collect(Collectors.toSet());
  }

  private static Set<BigInteger> serials(X509CRL list) {
    return Optional.ofNullable(list.getRevokedCertificates()).orElse(Set.of()).stream()
        .map(X509CRLEntry::getSerialNumber)
        .collect(Collectors.toSet());
  }

  /** The highest number that a list may have had. */
  private BigInteger last() throws IOException {
    BigInteger ofList = Files.exists(file()) ? number() : BigInteger.ZERO;
    Path file = folder.resolve(NUMBER);
    if (!Files.exists(file)) {
      return ofList;
    }
    String text = Files.readString(file).strip();
    if (!text.matches("\\d{1,40}")) {
      throw new AuthorityException(
          file + " has no number; write the highest number that a list had, such as " + ofList);
    }
    return ofList.max(new BigInteger(text));
  }

  private X509CRL read() throws IOException {
    try {
      return SignedFiles.revocations(bytes(), authority.chain().get(0), file().toString());
    } catch (IdentityException e) {
      throw new AuthorityException(
          file() + " is not this authority's list; delete it, and it is written again", e);
    }
  }

  private Path file() {
    return folder.resolve(SecurityFiles.REVOKED);
  }
}

package org.dfra.authority;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.math.BigInteger;
import java.time.Instant;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * A certificate that the authority has issued, as its register has it: a line of JSON.
 *
 * @param serial its serial number, in hexadecimal digits
 * @param role of the member; {@code code} of a certificate that signs code
 * @param name of the member
 * @param team of the member
 * @param from first instant, in ISO 8601
 * @param until last instant, in ISO 8601
 * @param revoked when it was revoked, in ISO 8601; null if it was not
 * @param reason why it was revoked; null if it was not
 */
@JsonInclude(JsonInclude.Include.NON_NULL)
public record IssuedCertificate(
    String serial,
    String role,
    String name,
    String team,
    String from,
    String until,
    @Nullable String revoked,
    @Nullable String reason) {

  private static final int HEXADECIMAL = 16;

  /** The role of certificates that sign code, which is none of a member. */
  public static final String CODE = "code";

  /** Checks the numbers and instants. */
  public IssuedCertificate {
    var unusedNumber = new BigInteger(serial, HEXADECIMAL);
    var unusedFrom = Instant.parse(from);
    var unusedUntil = Instant.parse(until);
    var unusedRevoked = revoked == null ? Instant.EPOCH : Instant.parse(revoked);
  }

  /** Its serial number. */
  BigInteger serialNumber() {
    return new BigInteger(serial, HEXADECIMAL);
  }

  /** When it was revoked. */
  public Optional<Instant> revokedAt() {
    return Optional.ofNullable(revoked).map(Instant::parse);
  }

  /** Whether it is revoked, or how its dates lie, in a word. */
  public String stateAt(Instant now) {
    if (revoked != null) {
      return "revoked";
    }
    return now.isAfter(Instant.parse(until)) ? "expired" : "valid";
  }

  /** It, revoked. */
  IssuedCertificate revoked(Instant when, String why) {
    return new IssuedCertificate(serial, role, name, team, from, until, when.toString(), why);
  }

  /** Whose it is, such as {@code robot atrv1}. */
  public String owner() {
    return role + " " + name;
  }
}

package org.dfra.river.identity;

import java.nio.ByteBuffer;
import java.security.cert.CertificateException;
import java.security.cert.X509Certificate;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.dfra.security.Caller.Standing;
import org.dfra.security.Member;
import org.jspecify.annotations.Nullable;

/**
 * Verifies delegations that calls carry. The signature of one is verified once; whether it counts
 * now is asked for each call. Thread-safe.
 */
final class DelegationVerifier {

  /** So many different ones are known at once; members have few. */
  private static final int MAX_KNOWN = 64;

  /** By so much the clock of the one who delegates may be ahead. */
  private static final Duration CLOCKS = Duration.ofMinutes(5);

  private static final String REMEDY = "; ask for a new one: security delegate";

  private final Member own;
  private final MemberTrust trust;
  private final InstantSource clock;
  private final ConcurrentHashMap<ByteBuffer, Delegation> known = new ConcurrentHashMap<>();

  /**
   * @param own who is called
   * @param clock of the one who is called; while a {@link FlooredClock} is not set, no delegation
   *     counts, since its time stands still
   */
  DelegationVerifier(Member own, MemberTrust trust, InstantSource clock) {
    this.own = own;
    this.trust = trust;
    this.clock = clock;
  }

  /**
   * Reads one, and checks that a member of the team has signed it.
   *
   * @throws IdentityException if it is none; the message is a sentence
   */
  Delegation signed(byte[] credential) throws IdentityException {
    ByteBuffer key = ByteBuffer.wrap(credential).asReadOnlyBuffer();
    @Nullable Delegation found = known.get(key);
    if (found != null) {
      return found;
    }
    Delegation read = Delegation.parse(credential, "the delegation that the call carries");
    try {
      trust.checkClient(read.certificate());
    } catch (CertificateException e) {
      throw new IdentityException("the " + read + " does not count: " + e.getMessage(), e);
    }
    if (known.size() >= MAX_KNOWN) {
      known.clear();
    }
    known.put(key, read);
    return read;
  }

  /**
   * Why it does not count for a call now, in a sentence, which is the same for each call: the audit
   * trail sums equal refusals.
   *
   * @param bearer who calls
   * @param certificate of the connection
   * @return empty if it counts
   */
  Optional<String> fault(Delegation delegation, Member bearer, X509Certificate certificate) {
    if (!delegation.bearer().equals(bearer)
        || !delegation.fingerprint().equals(Delegation.fingerprint(certificate))) {
      return Optional.of(
          "the "
              + delegation
              + " is for the certificate that "
              + delegation.bearer()
              + " had when it was signed, and does not count for "
              + bearer
              + REMEDY);
    }
    return faultNow(delegation);
  }

  /** The same for a bearer that was checked before. */
  Optional<String> faultNow(Delegation delegation) {
    if (!delegation.robots().contains(own.name())) {
      return Optional.of(
          "the "
              + delegation
              + " is for "
              + String.join(", ", delegation.robots())
              + ", and not for "
              + own
              + REMEDY);
    }
    if (clock instanceof FlooredClock known && !known.isSet()) {
      return Optional.of(
          "it is not known whether the "
              + delegation
              + " still lasts, since the clock of "
              + own
              + " was not set; set it");
    }
    Instant now = clock.instant();
    if (now.isAfter(delegation.until())) {
      return Optional.of("the " + delegation + " has expired at " + delegation.until() + REMEDY);
    } else if (now.isBefore(delegation.issued().minus(CLOCKS))) {
      return Optional.of(
          "the "
              + delegation
              + " was signed at "
              + delegation.issued()
              + ", which is later than it is by the clock of "
              + own
              + "; set the clocks");
    }
    Standing standing = trust.standing(delegation.certificate());
    return switch (standing) {
      case MEMBER -> Optional.empty();
      case EXPIRED ->
          Optional.of("the certificate of " + delegation.principal() + " has expired" + REMEDY);
      case OWN, STRANGER ->
          Optional.of(
              "the certificate of " + delegation.principal() + " is revoked or not valid" + REMEDY);
    };
  }
}

package org.dfra.river.transport;

import java.io.ByteArrayInputStream;
import java.security.GeneralSecurityException;
import java.security.cert.CertificateFactory;
import java.security.cert.X509CRL;
import java.security.cert.X509Certificate;
import java.time.Clock;
import java.time.InstantSource;
import java.util.List;
import java.util.Set;
import org.dfra.river.fixture.TestTeam;
import org.dfra.river.fixture.TestTeam.Issued;
import org.dfra.river.identity.RevokedCertificates;
import org.dfra.river.identity.TeamIdentity;
import org.dfra.security.Decision;
import org.dfra.security.Guard;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;

/** Identities of a team of tests. */
final class TestIdentities {

  private final TestTeam authority;
  private final RevokedCertificates revoked;

  TestIdentities(TestTeam authority) {
    this.authority = authority;
    this.revoked = new RevokedCertificates(authority.authority());
  }

  /** Gives all identities a list of revoked certificates. Returns whether it is newer. */
  boolean revoke(TestTeam signer, long number, X509Certificate... certificates)
      throws GeneralSecurityException {
    return revoked.replace(
        (X509CRL)
            CertificateFactory.getInstance("X.509")
                .generateCRL(new ByteArrayInputStream(signer.revocations(number, certificates))));
  }

  TeamIdentity of(MemberRole role, String name) {
    return of(role, name, authority.issue(new Member("field", role, name)));
  }

  /** An identity with a guard of its own. */
  TeamIdentity guarded(MemberRole role, String name, Guard guard) {
    return identity(role, name, authority.issue(new Member("field", role, name)), guard);
  }

  /** An identity with a guard and a clock of its own. */
  TeamIdentity guardedWithClock(MemberRole role, String name, Guard guard, InstantSource clock) {
    Issued issued = authority.issue(new Member("field", role, name));
    return identity(role, name, issued, guard, clock);
  }

  /** An identity that presents any certificate, of any issuer. */
  TeamIdentity of(MemberRole role, String name, Issued issued) {
    return identity(role, name, issued, request -> Decision.permit("all"));
  }

  /** An identity with a clock of its own. */
  TeamIdentity withClock(MemberRole role, String name, InstantSource clock) {
    Issued issued = authority.issue(new Member("field", role, name));
    return identity(role, name, issued, request -> Decision.permit("all"), clock);
  }

  private TeamIdentity identity(MemberRole role, String name, Issued issued, Guard guard) {
    return identity(role, name, issued, guard, Clock.systemUTC());
  }

  private TeamIdentity identity(
      MemberRole role, String name, Issued issued, Guard guard, InstantSource clock) {
    try {
      return new TeamIdentity(
          new TeamIdentity.Settings(
              new Member("field", role, name),
              new TeamIdentity.Key(issued.key(), List.of(issued.certificate())),
              Set.of(),
              Set.of(),
              authority.authority(),
              revoked,
              guard,
              false),
          clock);
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException(e);
    }
  }
}

package org.dfra.river.transport;

import java.security.GeneralSecurityException;
import java.time.Clock;
import java.util.List;
import java.util.Set;
import org.dfra.river.fixture.TestAuthority;
import org.dfra.river.fixture.TestAuthority.Issued;
import org.dfra.river.identity.RevokedCertificates;
import org.dfra.river.identity.TeamIdentity;
import org.dfra.security.Decision;
import org.dfra.security.Guard;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;

/** Identities of a team of tests. */
final class TestIdentities {

  private final TestAuthority authority;
  private final RevokedCertificates revoked;

  TestIdentities(TestAuthority authority) {
    this.authority = authority;
    this.revoked = new RevokedCertificates(authority.certificate());
  }

  RevokedCertificates revoked() {
    return revoked;
  }

  TeamIdentity of(MemberRole role, String name) {
    return of(role, name, authority.issue(role, name));
  }

  /** An identity with a guard of its own. */
  TeamIdentity guarded(MemberRole role, String name, Guard guard) {
    return identity(role, name, authority.issue(role, name), guard);
  }

  /** An identity that presents any certificate, whoever has issued it. */
  TeamIdentity of(MemberRole role, String name, Issued issued) {
    return identity(role, name, issued, request -> Decision.permit("all"));
  }

  private TeamIdentity identity(MemberRole role, String name, Issued issued, Guard guard) {
    try {
      return new TeamIdentity(
          new TeamIdentity.Settings(
              new Member("field", role, name),
              new TeamIdentity.Key(issued.key(), List.of(issued.certificate())),
              Set.of(),
              Set.of(),
              authority.certificate(),
              revoked,
              guard,
              false),
          Clock.systemUTC());
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException(e);
    }
  }
}

package org.dfra.benchmarks.secure;

import java.io.IOException;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Set;
import org.dfra.authority.Authority;
import org.dfra.authority.Authority.IssuedBundle;
import org.dfra.cli.security.IdentityInstaller;
import org.dfra.cli.security.VerifiedBundle;
import org.dfra.core.audit.AuditKind.SecurityMode;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.IdentityFolder;
import org.dfra.river.identity.RevokedCertificates;
import org.dfra.river.identity.TeamCredentials;
import org.dfra.river.identity.TeamIdentity;
import org.dfra.river.security.SecureProcess;
import org.dfra.security.Decision;
import org.dfra.security.MemberRole;

/** A team that exists for one run of a benchmark. */
public final class BenchTeam implements AutoCloseable {

  private static final String TEAM = "benchmark";
  private static final String PASSPHRASE = "of-this-run";
  private static final Duration VALIDITY = Duration.ofDays(1);

  private final Authority authority;

  private BenchTeam(Authority authority) {
    this.authority = authority;
  }

  /**
   * Makes a team.
   *
   * @param folder for its authority, which does not exist yet
   */
  public static BenchTeam create(Path folder) throws IOException {
    Authority.create(folder, TEAM, PASSPHRASE, true, Clock.systemUTC());
    return new BenchTeam(Authority.open(folder, () -> PASSPHRASE, Clock.systemUTC()));
  }

  /**
   * Issues a bundle, and joins with it.
   *
   * @param state the member's state folder, which this makes
   * @return the folder of the identity
   */
  public Path join(Path state, MemberRole role, String name) throws IOException {
    IssuedBundle issued = authority.issue(role, name, VALIDITY);
    IdentityInstaller installer = new IdentityInstaller(state);
    try {
      installer.install(
          VerifiedBundle.open(issued.bundle(), issued.passphrase(), "the bundle"),
          "the bundle",
          Instant.now(),
          false);
    } catch (IdentityException e) {
      throw new IOException(e);
    }
    return installer.folder();
  }

  /**
   * Gives this process the identity of a folder.
   *
   * @throws IOException if it is not secure then
   */
  public static void install(Path folder) throws IOException {
    SecureProcess.Installed installed = SecureProcess.install(folder, false);
    if (installed.mode() != SecurityMode.SECURE) {
      throw new IOException("this process is " + installed.mode() + ": " + installed.fault());
    }
  }

  /** An identity for a few calls of this process, which believes no list of revoked ones. */
  static TeamIdentity identity(Path folder) throws IdentityException, GeneralSecurityException {
    TeamCredentials member = IdentityFolder.load(folder);
    return new TeamIdentity(
        new TeamIdentity.Settings(
            member.member(),
            new TeamIdentity.Key(member.privateKey(), List.of(member.chain())),
            Set.of(),
            member.subject().getPrincipals(),
            member.authority(),
            new RevokedCertificates(member.authority()),
            request -> Decision.permit("a client"),
            false),
        Clock.systemUTC());
  }

  /**
   * Revokes a member.
   *
   * @return the new list
   */
  byte[] revoke(String name) throws IOException {
    if (authority.revoke(each -> each.name().equals(name), "benchmark").isEmpty()) {
      throw new IOException("no certificate of " + name + " was revoked");
    }
    return authority.revocations();
  }

  @Override
  public void close() throws IOException {
    authority.close();
  }
}

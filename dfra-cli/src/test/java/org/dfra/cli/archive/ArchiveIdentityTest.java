package org.dfra.cli.archive;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import org.dfra.core.policy.Policy;
import org.dfra.core.policy.PolicyStore;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.dfra.river.identity.IdentityFolder;
import org.dfra.river.identity.TeamCredentials;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The identity with which an archive is written passes every check of a member's: otherwise the
 * archive would silently have the classes of an open robot only.
 */
class ArchiveIdentityTest {

  @TempDir Path temp;

  @Test
  void aSecureRobotStartsWithIt() throws Exception {
    Path work = Files.createDirectory(temp.resolve("keys"));
    Path folder = temp.resolve("security");

    ArchiveIdentity.create(work, folder);

    TeamCredentials credentials = IdentityFolder.load(folder);
    assertThat(credentials.member())
        .isEqualTo(new Member(ArchiveIdentity.NAME, MemberRole.ROBOT, ArchiveIdentity.NAME));
    assertThat(credentials.validityFault(Instant.now())).isEmpty();
    assertThat(credentials.robotKey()).isPresent();
    Policy policy =
        new PolicyStore(folder, credentials.authority(), InterfaceCatalogue.builtIn())
            .load()
            .orElseThrow();
    assertThat(policy.team()).isEqualTo(ArchiveIdentity.NAME);
    assertThat(work.resolve("all.p12")).as("the authority's key").doesNotExist();
  }
}

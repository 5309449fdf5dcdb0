package org.dfra.river.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dfra.river.loading.CodeTrust.DownloadLimits;
import org.junit.jupiter.api.Test;

/** On a computer of a team, its authority is asked about signers that no trust file names. */
class TeamSignedJarTest extends ServedJarFixture {

  private final CodebaseUrl url =
      CodebaseUrl.parse("httpmd://h:1/lidar-dl.jar;sha-256=" + "a".repeat(64)).get(0);

  private VerifiedJar signed() throws Exception {
    team.sign(jar);
    return VerifiedJar.read(url, Files.readAllBytes(jar), DownloadLimits.DEFAULT);
  }

  @Test
  void theTeamIsAskedAboutTheKeyThatSigned() throws Exception {
    List<Object> asked = new ArrayList<>();
    signed()
        .requireSigned(
            url,
            Set.of(),
            chain -> {
              asked.add(chain.get(0));
              return Optional.empty();
            });
    assertThat(asked).isNotEmpty().containsOnly(team.certificate());
  }

  @Test
  void whatTheTeamRefusesIsNotLoaded() throws Exception {
    VerifiedJar signed = signed();
    assertThatThrownBy(
            () -> signed.requireSigned(url, Set.of(), chain -> Optional.of("was lost in a train")))
        .isInstanceOf(CodeRefusedException.class)
        .hasMessageContaining("is signed by " + team.certificate().getSubjectX500Principal())
        .hasMessageEndingWith(", which was lost in a train");
  }

  @Test
  void aKeyOfTheTrustFileNeedsNoTeam() throws Exception {
    signed().requireSigned(url, Set.of(team.certificate()), chain -> Optional.of("is of nobody"));
  }

  @Test
  void anUnsignedJarIsNobodys() throws Exception {
    VerifiedJar unsigned = VerifiedJar.read(url, Files.readAllBytes(jar), DownloadLimits.DEFAULT);
    assertThatThrownBy(() -> unsigned.requireSigned(url, Set.of(), chain -> Optional.empty()))
        .isInstanceOf(CodeRefusedException.class)
        .hasMessageContaining("the jar is not signed");
  }
}

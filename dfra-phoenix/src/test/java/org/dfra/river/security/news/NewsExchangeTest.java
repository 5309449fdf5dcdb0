package org.dfra.river.security.news;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.dfra.river.fixture.TestTeam;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.river.identity.SignedFiles;
import org.dfra.river.security.news.TeamNews.Numbers;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Two processes of a team, each with a folder of its own, that call each other directly. */
class NewsExchangeTest {

  private static final TestTeam TEAM = new TestTeam("field");

  @TempDir private Path folders;

  private Path here;
  private Path there;
  private NewsExchange exchange;
  private TeamNews other;

  @BeforeEach
  void join() throws IOException {
    here = folder("here");
    there = folder("there");
    exchange = new NewsExchange(here, TEAM.authority(), () -> numbers(here));
    other = new NewsService(new NewsFiles(there, TEAM.authority()), () -> numbers(there));
  }

  private Path folder(String name) throws IOException {
    return Files.createDirectory(
        folders.resolve(name),
        PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------")));
  }

  private static Path list(Path folder) {
    return folder.resolve(SecurityFiles.REVOKED);
  }

  private static Numbers numbers(Path folder) {
    try {
      long number =
          Files.exists(list(folder))
              ? SignedFiles.number(
                      SignedFiles.revocations(
                          Files.readAllBytes(list(folder)), TEAM.authority(), "list"))
                  .orElseThrow()
                  .longValue()
              : 0;
      return new Numbers(number, 0);
    } catch (Exception e) {
      throw new IllegalStateException(e);
    }
  }

  @Test
  void theOneWithTheOlderListTakesTheNewerOne() throws IOException {
    Files.write(list(here), TEAM.revocations(3));
    assertThat(exchange.exchange(other)).isEqualTo(new Numbers(3, 0));
    assertThat(list(there)).hasSameBinaryContentAs(list(here));

    Files.write(list(there), TEAM.revocations(5));
    assertThat(exchange.exchange(other)).isEqualTo(new Numbers(5, 0));
    assertThat(list(here)).hasSameBinaryContentAs(list(there));
  }

  @Test
  void nothingOlderOrForgedIsTaken() throws IOException {
    byte[] fourth = TEAM.revocations(4);
    other.takeRevocations(fourth);
    other.takeRevocations(TEAM.revocations(2));
    assertThat(list(there)).hasBinaryContent(fourth);
    assertThatThrownBy(() -> other.takeRevocations(new TestTeam("field").revocations(9)))
        .isInstanceOf(IOException.class)
        .hasMessageContaining(
            "the list of revoked certificates that was offered is not signed by the authority");
    assertThatThrownBy(() -> other.takeRevocations(new byte[100]))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("is no list of revoked certificates");
    assertThatThrownBy(() -> other.takeRevocations(new byte[64 << 20]))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("67108864 bytes");
    assertThat(list(there)).hasBinaryContent(fourth);
  }

  @Test
  void aListThatIsMissingIsReported() {
    assertThatThrownBy(other::revocations).isInstanceOf(IOException.class);
    assertThatThrownBy(other::policy).isInstanceOf(IOException.class);
  }
}

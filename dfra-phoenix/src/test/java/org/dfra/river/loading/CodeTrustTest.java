package org.dfra.river.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Base64;
import org.dfra.river.fixture.SignerKey;
import org.dfra.river.loading.CodeTrust.DownloadLimits;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CodeTrustTest {

  @TempDir private Path folder;

  @Test
  void readsAStoreAFolderPinnedDigestsAndLimits() throws Exception {
    SignerKey inStore = SignerKey.create(folder, "in-store");
    SignerKey inFolder = SignerKey.create(folder, "in-folder");
    Files.createDirectories(folder.resolve("keys"));
    Files.writeString(
        folder.resolve("keys/team.pem"),
        "-----BEGIN CERTIFICATE-----\n"
            + Base64.getMimeEncoder().encodeToString(inFolder.certificate().getEncoded())
            + "\n-----END CERTIFICATE-----\n");
    String digest = "AB".repeat(32);
    CodeTrust trust =
        CodeTrust.read(
            file(
                "trust.store = in-store.p12\ntrust.store.password = "
                    + SignerKey.PASSWORD
                    + "\ntrust.certificates = keys\npinned.lidar = "
                    + digest
                    + "\ndownload.bytes = 1000\ndownload.unpacked.bytes = 2000\n"
                    + "download.entries = 3\ndownload.millis = 400\n"));
    assertThat(trust.signers())
        .containsExactlyInAnyOrder(inStore.certificate(), inFolder.certificate());
    assertThat(trust.pinned()).containsExactly("ab".repeat(32));
    assertThat(trust.limits()).isEqualTo(new DownloadLimits(1000, 2000, 3, Duration.ofMillis(400)));
  }

  @Test
  void trustsNobodyByDefault() throws Exception {
    assertThat(CodeTrust.configured()).isEqualTo(CodeTrust.NONE);
    assertThat(CodeTrust.read(file(""))).isEqualTo(CodeTrust.NONE);
  }

  @ParameterizedTest
  @CsvSource({
    "trust.stroe = x, trust.stroe is not a key of a trust file; use ",
    "trust.store = missing.p12, 'trust.store = '",
    "trust.certificates = missing, 'trust.certificates = '",
    "trust.certificates = empty, '*.pem, *.crt or *.cer; put certificates there'",
    "trust.certificates = broken, 'is not a certificate'",
    "pinned.lidar = 00, 'pinned.lidar = \"00\" is not a SHA-256; write its 64 hexadecimal digits'",
    "download.bytes = 0, 'download.bytes = \"0\" is not a whole number from 1 to 2147483639;"
        + " correct it'",
    "download.millis = soon, 'download.millis = \"soon\" is not a whole number from 1 to 600000'"
  })
  void saysWhichKeyOfWhichFileIsWrong(String line, String says) throws IOException {
    Files.createDirectories(folder.resolve("empty"));
    Files.createDirectories(folder.resolve("broken"));
    Files.writeString(folder.resolve("broken/a.pem"), "-----BEGIN CERTIFICATE-----\nAAAA\n");
    Path file = file(line);
    assertThatThrownBy(() -> CodeTrust.read(file))
        .isInstanceOf(IOException.class)
        .hasMessageStartingWith(file + ": ")
        .hasMessageContaining(says);
  }

  @Test
  void saysThatThePasswordIsWrong() throws Exception {
    SignerKey.create(folder, "team");
    Path file = file("trust.store = team.p12\ntrust.store.password = wrong\n");
    assertThatThrownBy(() -> CodeTrust.read(file))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("trust.store = " + folder.resolve("team.p12") + " cannot be opened")
        .hasMessageContaining("correct it or trust.store.password");
  }

  @Test
  void saysThatTheFileIsMissing() {
    Path missing = folder.resolve("missing.properties");
    assertThatThrownBy(() -> CodeTrust.read(missing))
        .isInstanceOf(IOException.class)
        .hasMessageContaining(missing.toString())
        .hasMessageContaining("-Ddfra.trust");
  }

  private Path file(String text) throws IOException {
    return Files.writeString(folder.resolve("trust.properties"), text);
  }
}

package org.dfra.drivers.link;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static java.util.concurrent.TimeUnit.SECONDS;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import org.dfra.drivers.fixture.Modules;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Two pseudo-terminals, joined by socat: what goes into one comes out of the other. */
@Timeout(120)
class SerialPortLinkTest {

  private static final Duration LONG = Duration.ofSeconds(40);

  @TempDir private Path folder;
  private Process socat;
  private Path here;
  private Path there;
  private final byte[] buffer = new byte[64];

  @BeforeEach
  void joinPorts() throws IOException {
    assumeTrue(isInstalled("socat"), "socat is not installed: serial ports are not tested");
    here = folder.resolve("here");
    there = folder.resolve("there");
    socat =
        new ProcessBuilder("socat", "pty,raw,echo=0,link=" + here, "pty,raw,echo=0,link=" + there)
            .inheritIO()
            .start();
    Modules.await().until(() -> Files.exists(here) && Files.exists(there));
  }

  @AfterEach
  void unplug() throws InterruptedException {
    if (socat != null) {
      socat.destroyForcibly().waitFor();
    }
  }

  @Test
  void carriesBytesBothWays() throws IOException {
    try (SerialLink device = LinkAddress.open("serial:" + there)) {
      try (SerialLink link = LinkAddress.open("serial:" + here + "?baud=9600")) {
        link.write("poll".getBytes(US_ASCII));
        assertThat(readFour(device)).isEqualTo("poll");
        device.write("fix!".getBytes(US_ASCII));
        assertThat(readFour(link)).isEqualTo("fix!");
        assertThat(link.read(buffer, 0, 10, Duration.ofMillis(1))).isZero();
        assertThat(link.isOpen()).isTrue();
      }
    }
  }

  @Test
  void changesItsSpeedWhileItIsOpen() throws IOException {
    try (SerialLink device = LinkAddress.open("serial:" + there)) {
      SerialLink link = LinkAddress.open("serial:" + here + "?baud=9600");
      link.setBaud(38_400);
      link.write("poll".getBytes(US_ASCII)); // a pseudo-terminal has no speed, but must be sound
      assertThat(readFour(device)).isEqualTo("poll");
      device.write("fix!".getBytes(US_ASCII));
      assertThat(readFour(link)).isEqualTo("fix!");
      link.close();
      assertThatThrownBy(() -> link.setBaud(9600))
          .isInstanceOf(IOException.class)
          .hasMessageContaining("cannot be set to 9600 baud, or is lost");
    }
  }

  @Test
  void closeFreesAWaitingReader() throws Exception {
    SerialLink link = LinkAddress.open("serial:" + here);
    CompletableFuture<Integer> read =
        CompletableFuture.supplyAsync(() -> link.read(buffer, 0, 10, Duration.ofHours(1)));
    link.close();
    assertThat(read.get(40, SECONDS)).isEqualTo(-1);
    assertThat(link.isOpen()).isFalse();
  }

  @Test
  void reportsThatTheDeviceIsLost() throws Exception {
    try (SerialLink link = LinkAddress.open("serial:" + here)) {
      socat.destroy();
      socat.waitFor();
      Modules.await()
          .untilAsserted(
              () -> assertThat(link.read(buffer, 0, 10, Duration.ofMillis(100))).isEqualTo(-1));
    }
  }

  private String readFour(SerialLink link) {
    int filled = 0;
    while (filled < 4) {
      int count = link.read(buffer, filled, 4 - filled, LONG);
      assertThat(count).as("bytes after %d of 4", filled).isPositive();
      filled += count;
    }
    return new String(buffer, 0, 4, US_ASCII);
  }

  private static boolean isInstalled(String program) {
    for (String folder : System.getenv().getOrDefault("PATH", "").split(File.pathSeparator, -1)) {
      if (Files.isExecutable(Path.of(folder, program))) {
        return true;
      }
    }
    return false;
  }
}

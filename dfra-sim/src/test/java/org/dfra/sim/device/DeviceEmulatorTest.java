package org.dfra.sim.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.time.InstantSource;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Which of two clients a device serves. */
@Timeout(30)
class DeviceEmulatorTest {

  private final DeviceEmulator emulator =
      new DeviceEmulator("echo", 0, new EchoDevice(0), InstantSource.system());

  @BeforeEach
  void start() throws IOException {
    emulator.start();
  }

  @AfterEach
  void close() {
    emulator.close();
  }

  @Test
  void disconnectsAStrangerWhileTheDriverSends() throws Exception {
    try (Socket driver = connect()) {
      assertThat(echo(driver, 'a')).isEqualTo('a');
      try (Socket stranger = connect()) {
        assertThat(isEnded(stranger)).isTrue();
      }
      assertThat(echo(driver, 'b')).isEqualTo('b');
    }
  }

  @Test
  void servesTheNextClientWhenTheDriverHasGone() throws Exception {
    try (Socket driver = connect()) {
      assertThat(echo(driver, 'a')).isEqualTo('a');
    }
    try (Socket next = connect()) {
      assertThat(echo(next, 'b')).isEqualTo('b');
    }
  }

  @Test
  void givesThePlaceOfAClientThatSendsNothingToANewOne() throws Exception {
    try (Socket silent = connect();
        Socket next = connect()) {
      assertThat(echo(next, 'a')).isEqualTo('a');
      assertThat(isEnded(silent)).isTrue();
    }
  }

  private Socket connect() throws IOException {
    return new Socket(InetAddress.getLoopbackAddress(), emulator.port());
  }

  private static int echo(Socket client, int sent) throws IOException {
    client.getOutputStream().write(sent);
    return client.getInputStream().read();
  }

  private static boolean isEnded(Socket client) throws IOException {
    try {
      return client.getInputStream().read() < 0;
    } catch (SocketException e) { // ended with a reset
      return true;
    }
  }
}

package org.dfra.river.phoenix.access;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.rmi.AccessException;
import java.rmi.registry.LocateRegistry;
import java.rmi.registry.Registry;
import java.rmi.server.UnicastRemoteObject;
import org.dfra.core.host.FreePorts;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A registry of the JDK behind these sockets. */
@Timeout(60)
class ReadOnlyRegistrySocketFactoryTest {

  private static final String ACKNOWLEDGEMENT = "N\000\013203.0.113.1";

  private int port;
  private Registry registry;

  @BeforeEach
  void start() throws Exception {
    port = FreePorts.allocate();
    registry = LocateRegistry.createRegistry(port, null, new ReadOnlyRegistrySocketFactory());
    registry.bind("here", registry);
  }

  @AfterEach
  void end() throws Exception {
    UnicastRemoteObject.unexportObject(registry, true);
  }

  /** Also with one of another host, as far as a registry on the loopback interface sees one. */
  @ParameterizedTest
  @ValueSource(strings = {"127.0.0.1", "127.0.0.2"})
  void acknowledgesWithTheCallersTrueAddress(String address) throws IOException {
    InetAddress loopback = InetAddress.getLoopbackAddress();
    try (Socket caller = new Socket(loopback, port, InetAddress.getByName(address), 0)) {
      DataOutputStream out = new DataOutputStream(caller.getOutputStream());
      out.write("JRMI".getBytes(StandardCharsets.US_ASCII));
      out.writeShort(2); // version
      out.writeByte(0x4B); // stream protocol
      out.flush();
      DataInputStream in = new DataInputStream(caller.getInputStream());
      assertThat(in.readByte()).as("acknowledged").isEqualTo((byte) 0x4E);
      assertThat(in.readUTF()).isEqualTo(address);
      assertThat(in.readInt()).isEqualTo(caller.getLocalPort());
    }
  }

  @Test
  void staysReadOnly() throws Exception {
    Registry remote = LocateRegistry.getRegistry("127.0.0.1", port);
    assertThat(remote.list()).containsExactly("here");
    assertThatThrownBy(() -> remote.unbind("here")).hasRootCauseInstanceOf(AccessException.class);
    assertThat(remote.list()).containsExactly("here");
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 5, 100})
  void replacesTheAddressHoweverItIsCut(int chunk) throws IOException {
    assertThat(sent(ACKNOWLEDGEMENT + "and more", chunk)).isEqualTo("N\000\0117.1.2.345and more");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"", "Q\000\013203.0.113.1", "N\000\013203.0.113.2", "N\000\01210.1", "NN"})
  void passesEverythingElse(String bytes) throws IOException {
    for (int chunk : new int[] {1, 3, 100}) {
      assertThat(sent(bytes + "!", chunk)).isEqualTo(bytes + "!");
    }
  }

  @Test
  void replacesTheFirstAcknowledgementOnly() throws IOException {
    assertThat(sent("Q" + ACKNOWLEDGEMENT, 100)).isEqualTo("Q" + ACKNOWLEDGEMENT);
  }

  private static String sent(String bytes, int chunk) throws IOException {
    ByteArrayOutputStream sink = new ByteArrayOutputStream();
    byte[] all = bytes.getBytes(StandardCharsets.ISO_8859_1);
    try (AddressRewritingStream out =
        new AddressRewritingStream(sink, "203.0.113.1", "7.1.2.345")) {
      for (int at = 0; at < all.length; at += chunk) {
        out.write(all, at, Math.min(chunk, all.length - at));
      }
    }
    return sink.toString(StandardCharsets.ISO_8859_1);
  }
}

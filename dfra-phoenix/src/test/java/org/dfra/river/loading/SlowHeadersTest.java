package org.dfra.river.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.dfra.core.time.StallProbe;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Clients of a {@link ClassServer} that do not end their requests, or do not take the answers. */
@Timeout(60)
class SlowHeadersTest {

  private static final String HOST = InetAddress.getLoopbackAddress().getHostAddress();
  private static final byte[] JAR = "the jar".getBytes(StandardCharsets.UTF_8);

  /** The requirement for an honest download while others send slowly. */
  private static final Duration DOWNLOADED = Duration.ofSeconds(1);

  /** Without the empty line that ends it. */
  private static final String REQUEST = "GET /a.jar HTTP/1.1\r\n";

  /** More than the buffers of a connection hold. */
  private static final int BIG = 16 << 20;

  @TempDir private Path folder;
  private ClassServer server;
  private final List<Socket> sockets = new ArrayList<>();
  private final StallProbe probe = StallProbe.start();

  @BeforeEach
  void start() throws IOException {
    Files.write(folder.resolve("a.jar"), JAR);
    Files.write(folder.resolve("big.jar"), new byte[BIG]);
    server = new ClassServer(HOST, 0, folder, List.of("a.jar", "big.jar"));
    server.start();
  }

  @AfterEach
  void close() throws IOException {
    probe.close();
    for (Socket socket : sockets) {
      socket.close();
    }
    server.close();
  }

  @Test
  void endsARequestThatDoesNotArriveInTime() throws Exception {
    Socket slow = begin("127.0.0.1");

    assertThat(isEnded(slow)).isTrue();

    assertThat(download()).isEqualTo(JAR);
  }

  @Test
  void leavesPlacesForOthersBesideOneAddressThatTakesAllItCan() throws Exception {
    assumeThat(hasAddress("127.0.0.66")).as("other addresses of 127/8 can be used").isTrue();
    for (int i = 0; i < HttpListener.PER_ADDRESS; i++) {
      hold("127.0.0.66");
    }
    for (int i = 0; i < 8; i++) {
      assertThat(isEnded(send("127.0.0.66", REQUEST + "\r\n")))
          .as("without an answer, though there are places")
          .isTrue();
    }
    assertThat(download()).isEqualTo(JAR);
  }

  @Test
  void givesTheOldestIncompleteRequestsPlaceToANewClientWhereAllAreTaken() throws Exception {
    assumeThat(hasAddress("127.0.0.66")).as("other addresses of 127/8 can be used").isTrue();
    for (int i = 0; i < HttpListener.CONNECTIONS; i++) { // no address holds more than the client
      begin("127.0.1." + (1 + i));
    }

    assertThat(download()).isEqualTo(JAR);

    assertThat(isEnded(sockets.get(0))).isTrue();
  }

  @Test
  void honestDownloadsTakeASecondAtMostWhereAllPlacesAreTaken() throws Exception {
    assumeThat(hasAddress("127.0.0.66")).as("other addresses of 127/8 can be used").isTrue();
    assertThat(download()).isEqualTo(JAR); // the client's classes are loaded now
    int addresses = HttpListener.CONNECTIONS / HttpListener.PER_ADDRESS;
    for (int i = 0; i < HttpListener.CONNECTIONS; i++) {
      begin("127.0.3." + (1 + i % addresses));
    }
    for (int i = 0; i < 3; i++) {
      StallProbe.Stopwatch began = probe.stopwatch();
      assertThat(download()).isEqualTo(JAR);
      began.stop().requireWithin("an honest download beside slow requests", DOWNLOADED);
    }
  }

  @Test
  void givesAPlaceOfTheBusiestAddressToANewClientWhereNobodyTakesHisAnswer() throws Exception {
    assumeThat(hasAddress("127.0.0.66")).as("other addresses of 127/8 can be used").isTrue();
    int addresses = HttpListener.CONNECTIONS / HttpListener.PER_ADDRESS;
    for (int i = 0; i < HttpListener.CONNECTIONS; i++) {
      hold("127.0.2." + (1 + i % addresses));
    }

    assertThat(download()).isEqualTo(JAR);
  }

  @Test
  void refusesHeadersWithoutEnd() throws Exception {
    Socket socket = begin("127.0.0.1");
    String header = "x-a: " + "b".repeat(8192);
    socket.getOutputStream().write(header.getBytes(StandardCharsets.US_ASCII));
    String answer = new String(socket.getInputStream().readAllBytes(), StandardCharsets.US_ASCII);

    assertThat(answer).startsWith("HTTP/1.1 431 ");
  }

  private byte[] download() throws Exception {
    return HttpClient.newHttpClient()
        .send(
            HttpRequest.newBuilder(URI.create("http://" + HOST + ":" + server.port() + "/a.jar"))
                .timeout(Duration.ofSeconds(30))
                .build(),
            HttpResponse.BodyHandlers.ofByteArray())
        .body();
  }

  private Socket connect(String from) throws IOException {
    Socket socket = new Socket();
    sockets.add(socket);
    socket.setReceiveBufferSize(4096); // so that little of an answer is on its way
    socket.bind(new InetSocketAddress(from, 0));
    socket.connect(new InetSocketAddress(HOST, server.port()));
    socket.setSoTimeout(30_000);
    return socket;
  }

  /** Asks for the big jar, and takes no more of the answer than its beginning. */
  private void hold(String from) throws IOException {
    Socket slow = connect(from);
    byte[] request = "GET /big.jar HTTP/1.1\r\n\r\n".getBytes(StandardCharsets.US_ASCII);
    slow.getOutputStream().write(request);
    assertThat(slow.getInputStream().read()).as("the answer has begun").isEqualTo('H');
  }

  /** Sends a request that lacks its end. */
  private Socket begin(String from) throws IOException {
    return send(from, REQUEST);
  }

  private Socket send(String from, String request) throws IOException {
    Socket socket = connect(from);
    try {
      socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
    } catch (SocketException e) {
      assertThat(e).hasMessageMatching("(?i).*(reset|broken pipe).*"); // it was not admitted
    }
    return socket;
  }

  /** Waits until the server ends it. */
  private static boolean isEnded(Socket socket) throws IOException {
    try {
      InputStream in = socket.getInputStream();
      return in.read() < 0;
    } catch (SocketException e) { // ended with a reset, since bytes were unread
      return true;
    }
  }

  private static boolean hasAddress(String address) {
    try (Socket socket = new Socket()) {
      socket.bind(new InetSocketAddress(address, 0));
      return true;
    } catch (IOException e) { // only Linux has all of 127/8
      return false;
    }
  }
}

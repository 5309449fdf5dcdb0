package org.dfra.secure;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.io.IOException;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.dfra.core.host.ListeningSocket;

/** Attempts to call a robot's processes without encryption, as open ones are called. */
final class PlainCalls {

  private static final Path PROC = Path.of("/proc");
  private static final int TIMEOUT_MILLIS = 1000;
  private static final int GREETING = 24;
  private static final int ANSWER = 8;
  private static final int CODE = 5;

  /** The beginning of a JRMP connection by the stream protocol, version 2. */
  private static final byte[] JRMP = {'J', 'R', 'M', 'I', 0, 2, 0x4b};

  /** The beginning of a connection of River's multiplexing protocol, version 1. */
  private static final byte[] MUX = {'M', 'u', 'x', 0, 1, 0, 0, 0};

  private PlainCalls() {}

  /** What a port answers to the greeting of a client that does not encrypt. */
  enum Greeted {
    /** It would serve the client. */
    WELCOME,
    /** It serves encrypted calls only. */
    ENCRYPTED_ONLY,
    /** It answers a client of JRMP or of River's own transport. */
    RIVER,
    /** None of them: it is for discovery, which only gives hints. */
    NO_CALLS
  }

  /**
   * All ports of a process that listen, and what they answer; asked at once, as some say nothing.
   */
  static Map<Integer, Greeted> toAllPortsOf(long pid) throws Exception {
    Set<String> own = new HashSet<>();
    try (DirectoryStream<Path> open =
        Files.newDirectoryStream(PROC.resolve(Long.toString(pid)).resolve("fd"))) {
      for (Path each : open) {
        if (Files.isSymbolicLink(each)) {
          own.add(Files.readSymbolicLink(each).toString());
        }
      }
    }
    ExecutorService threads = Executors.newCachedThreadPool();
    try {
      Map<Integer, Future<Greeted>> asked = new HashMap<>();
      for (ListeningSocket each : ListeningSocket.all(PROC)) {
        if (own.contains("socket:[" + each.inode() + "]")) {
          asked.put(each.port(), threads.submit(() -> greet(each.port())));
        }
      }
      Map<Integer, Greeted> answers = new HashMap<>();
      for (Map.Entry<Integer, Future<Greeted>> each : asked.entrySet()) {
        answers.put(each.getKey(), each.getValue().get());
      }
      return answers;
    } finally {
      threads.shutdownNow();
    }
  }

  /** See docs/reference/transport.md. */
  static Greeted greet(int port) throws IOException {
    try (Socket socket = new Socket(SecureTeam.HOST, port)) {
      socket.setSoTimeout(TIMEOUT_MILLIS);
      byte[] greeting =
          ByteBuffer.allocate(GREETING).put("DFRA".getBytes(US_ASCII)).put((byte) 1).array();
      socket.getOutputStream().write(greeting);
      socket.getOutputStream().flush();
      byte[] answer = socket.getInputStream().readNBytes(ANSWER);
      if (answer.length < ANSWER || !new String(answer, 0, 4, US_ASCII).equals("DFRA")) {
        return closest(port);
      }
      return answer[CODE] == 4 ? Greeted.ENCRYPTED_ONLY : Greeted.WELCOME;
    } catch (SocketException | SocketTimeoutException e) {
      return closest(port);
    }
  }

  private static Greeted closest(int port) throws IOException {
    return answers(port, JRMP) || answers(port, MUX) ? Greeted.RIVER : Greeted.NO_CALLS;
  }

  /** Whether it answers a greeting; to answer nothing, or to hang up, is none. */
  private static boolean answers(int port, byte... greeting) throws IOException {
    try (Socket socket = new Socket(SecureTeam.HOST, port)) {
      socket.setSoTimeout(TIMEOUT_MILLIS / 4);
      socket.getOutputStream().write(greeting);
      socket.getOutputStream().flush();
      return socket.getInputStream().read() >= 0;
    } catch (SocketException | SocketTimeoutException e) {
      return false;
    }
  }
}

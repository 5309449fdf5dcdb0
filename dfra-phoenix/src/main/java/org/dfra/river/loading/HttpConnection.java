package org.dfra.river.loading;

import java.io.BufferedOutputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Future;
import java.util.function.Consumer;
import org.dfra.river.loading.HttpListener.HttpResponder;
import org.dfra.river.loading.HttpListener.HttpResponder.HttpReply;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** One connection to an {@link HttpListener}: one request and one response, then it closes. */
final class HttpConnection implements Runnable {

  /** River's and the JDK's clients send less than 300 bytes. */
  private static final int HEADER_BYTES = 8192;

  private static final Map<Integer, String> REASONS =
      Map.of(
          200, "OK",
          400, "Bad Request",
          404, "Not Found",
          405, "Method Not Allowed",
          431, "Request Header Fields Too Large");

  private static final Logger LOG = LoggerFactory.getLogger(HttpConnection.class);

  private final Socket socket;
  private final InetAddress address;
  private final HttpResponder answers;
  private final Consumer<HttpConnection> ended;
  private volatile boolean complete;
  private volatile List<Future<?>> deadlines = List.of();

  /**
   * @param ended receives this connection when its thread has finished it
   */
  HttpConnection(Socket socket, HttpResponder answers, Consumer<HttpConnection> ended) {
    this.socket = socket;
    this.address = socket.getInetAddress();
    this.answers = answers;
    this.ended = ended;
  }

  /**
   * Sets the tasks that end this connection, unless it has already ended. Called before {@link
   * #run}.
   */
  void setDeadlines(Future<?>... deadlines) {
    this.deadlines = List.of(deadlines);
  }

  /** The client's address. */
  InetAddress address() {
    return address;
  }

  /** Whether the whole request has arrived. */
  boolean isComplete() {
    return complete;
  }

  /** Closes a connection whose request is still incomplete. */
  void abortIfIncomplete() {
    if (!complete) {
      abort();
    }
  }

  /** Closes it immediately; blocked readers and writers get an exception. */
  void abort() {
    try {
      socket.close();
    } catch (IOException e) {
      LOG.debug("A connection from {} could not be closed.", address, e);
    }
  }

  @Override
  public void run() {
    try (socket) {
      String header = header(socket.getInputStream());
      complete = true;
      OutputStream out = new BufferedOutputStream(socket.getOutputStream(), HEADER_BYTES);
      answer(header, out);
      out.flush();
      socket.shutdownOutput();
    } catch (IOException e) { // caused by the client: it disconnected or was too slow
      LOG.debug("A client at {} was not answered.", address, e);
    } finally {
      deadlines.forEach(deadline -> deadline.cancel(false));
      ended.accept(this);
    }
  }

  /** Reads up to the empty line; ignores the rest. */
  private static String header(InputStream in) throws IOException {
    ByteArrayOutputStream header = new ByteArrayOutputStream(512);
    int newlines = 0;
    while (newlines < 2 && header.size() < HEADER_BYTES) {
      int next = in.read();
      if (next < 0) {
        throw new IOException("the request ended before its empty line");
      }
      header.write(next);
      if (next == '\n') {
        newlines++;
      } else if (next != '\r') {
        newlines = 0;
      }
    }
    return newlines < 2 ? "" : header.toString(StandardCharsets.ISO_8859_1);
  }

  private void answer(String header, OutputStream out) throws IOException {
    if (header.isEmpty()) {
      write(out, new HttpReply(431, Map.of(), new byte[0]), true);
      return;
    }
    String[] request = header.lines().findFirst().orElse("").split(" ", -1);
    if (request.length != 3 || !request[2].startsWith("HTTP/1.")) {
      write(out, new HttpReply(400, Map.of(), new byte[0]), true);
      return;
    }
    boolean head = request[0].equals("HEAD");
    if (!head && !request[0].equals("GET")) {
      write(out, new HttpReply(405, Map.of("Allow", "GET, HEAD"), new byte[0]), true);
      return;
    }
    int query = request[1].indexOf('?');
    String path = query < 0 ? request[1] : request[1].substring(0, query);
    write(out, answers.answer(path), !head);
  }

  private static void write(OutputStream out, HttpReply answer, boolean withBody)
      throws IOException {
    StringBuilder head = new StringBuilder(256);
    head.append("HTTP/1.1 ").append(answer.status()).append(' ');
    head.append(REASONS.getOrDefault(answer.status(), "Other")).append("\r\n");
    answer.headers().forEach((name, value) -> line(head, name, value));
    line(head, "Content-Length", Integer.toString(answer.body().length));
    line(head, "Connection", "close");
    head.append("\r\n");
    out.write(head.toString().getBytes(StandardCharsets.ISO_8859_1));
    if (withBody) {
      out.write(answer.body());
    }
  }

  private static void line(StringBuilder head, String name, String value) {
    head.append(name).append(": ").append(value).append("\r\n");
  }
}

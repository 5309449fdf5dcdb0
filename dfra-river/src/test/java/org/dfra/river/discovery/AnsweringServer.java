package org.dfra.river.discovery;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.ObjectOutputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.rmi.MarshalledObject;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;

/** Answers unicast discovery as the test says, each client on a thread of its own. */
public final class AnsweringServer implements AutoCloseable {

  /** Writes an answer, or stalls. */
  public interface Answering {
    void answer(OutputStream out) throws IOException;
  }

  private final ServerSocket server;
  private final Answering answering;
  private final AtomicInteger asked = new AtomicInteger();

  public AnsweringServer(Answering answering) throws IOException {
    this.answering = answering;
    this.server = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    start(this::accept);
  }

  private static void start(Runnable role) {
    Thread thread = new Thread(role, "answers discovery");
    thread.setDaemon(true);
    thread.start();
  }

  private void accept() {
    while (!server.isClosed()) {
      try {
        Socket client = server.accept();
        start(() -> serve(client));
      } catch (IOException e) {
        if (!server.isClosed()) {
          throw new IllegalStateException(e);
        }
      }
    }
  }

  private void serve(Socket client) {
    try (client) {
      int version = new DataInputStream(client.getInputStream()).readInt();
      asked.incrementAndGet();
      if (version == 1) {
        answering.answer(client.getOutputStream());
      }
    } catch (IOException e) {
      if (!server.isClosed()) {
        System.err.println("a client of discovery ended early: " + e); // it may
      }
    }
  }

  /** The answer of a lookup service. */
  public static byte[] answer(Object proxy, List<String> groups) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(new MarshalledObject<>(proxy));
      out.writeInt(groups.size());
      for (String each : groups) {
        out.writeUTF(each);
      }
    }
    return bytes.toByteArray();
  }

  public String host() {
    return server.getInetAddress().getHostAddress();
  }

  public int port() {
    return server.getLocalPort();
  }

  /** How many clients asked. */
  int asked() {
    return asked.get();
  }

  @Override
  public void close() throws IOException {
    server.close();
  }
}

package org.dfra.benchmarks.event;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.LongConsumer;
import org.jspecify.annotations.Nullable;

/**
 * Messages over a socket for each listener. Each message has as many bytes as DFRA's call that
 * delivers an event, and is acknowledged by as many as DFRA's answer has.
 *
 * <p>Threads: one accepts, one for each listener writes a message and awaits the acknowledgement;
 * in a listener's process, one reads. All are daemons and live until the process ends.
 */
final class TcpEvents implements EventTransport {

  /** Bytes of DFRA's answer: a header, the result's kind and an empty object stream. */
  private static final int ANSWER = 12;

  private final List<BlockingQueue<Long>> listeners = new CopyOnWriteArrayList<>();
  private long number; // of the last event; only the publishing thread uses it
  private @Nullable ServerSocket port;

  @Override
  public ServedSource serve() throws Exception {
    int bytes = CallSize.ofEvent();
    ServerSocket open = new ServerSocket(0, 0, InetAddress.getByName(BenchActivation.HOST));
    port = open;
    start("accepts", () -> accept(open, bytes));
    return new ServedSource(Integer.toString(open.getLocalPort()), this::publish);
  }

  private void accept(ServerSocket open, int bytes) throws IOException {
    while (true) {
      Socket socket = open.accept();
      BlockingQueue<Long> events = new LinkedBlockingQueue<>();
      start("writes", () -> deliver(socket, events, bytes));
      listeners.add(events);
      socket.getOutputStream().write(0); // the listener gets all events from now on
    }
  }

  private static void deliver(Socket socket, BlockingQueue<Long> events, int bytes)
      throws IOException, InterruptedException {
    socket.setTcpNoDelay(true);
    DataOutputStream out =
        new DataOutputStream(new BufferedOutputStream(socket.getOutputStream(), 2 * bytes));
    DataInputStream in = new DataInputStream(new BufferedInputStream(socket.getInputStream()));
    byte[] message = new byte[bytes];
    byte[] answer = new byte[ANSWER];
    while (true) {
      ByteBuffer.wrap(message).putLong(events.take());
      out.writeInt(bytes);
      out.write(message);
      out.flush();
      in.readFully(answer, 0, in.readInt());
    }
  }

  private void publish() {
    number++;
    for (BlockingQueue<Long> each : listeners) {
      each.add(number);
    }
  }

  @Override
  public void listen(String address, LongConsumer received) throws Exception {
    Socket socket = new Socket(BenchActivation.HOST, Integer.parseInt(address));
    socket.setTcpNoDelay(true);
    if (socket.getInputStream().read() != 0) {
      throw new IOException("the source ended before it accepted the listener");
    }
    start("listens", () -> receive(socket, received));
  }

  private static void receive(Socket socket, LongConsumer received) throws IOException {
    DataInputStream in = new DataInputStream(new BufferedInputStream(socket.getInputStream()));
    DataOutputStream out = new DataOutputStream(new BufferedOutputStream(socket.getOutputStream()));
    byte[] answer = new byte[ANSWER];
    while (true) {
      byte[] message = new byte[in.readInt()];
      in.readFully(message);
      received.accept(ByteBuffer.wrap(message).getLong());
      out.writeInt(ANSWER);
      out.write(answer);
      out.flush();
    }
  }

  /** The role of a thread. */
  @FunctionalInterface
  private interface Role {
    void run() throws IOException, InterruptedException;
  }

  private static void start(String name, Role role) {
    Thread thread =
        new Thread(
            () -> {
              try {
                role.run();
              } catch (IOException | InterruptedException e) { // the comparison sees missing events
                throw new IllegalStateException("a thread that " + name + " has ended", e);
              }
            },
            name);
    thread.setDaemon(true);
    thread.start();
  }
}

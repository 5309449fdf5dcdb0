package org.dfra.benchmarks.call;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.time.Duration;
import org.jspecify.annotations.Nullable;
import org.zeromq.SocketType;
import org.zeromq.ZContext;
import org.zeromq.ZMQ;

/**
 * JeroMQ's request and reply sockets (REQ, REP) with messages of raw bytes. A request is one byte
 * for the method, and the argument; an answer is the result. Each calling thread has a socket, and
 * one thread of the server answers all of them, as a REP socket requires.
 */
final class JeroMqTransport implements CallTransport {

  private static final byte ECHO = 0;
  private static final byte VALUES = 1;
  private static final int PATIENCE_MILLIS = Math.toIntExact(Duration.ofMinutes(1).toMillis());

  @Override
  public String serve(Path folder) throws IOException {
    ZContext context = new ZContext();
    ZMQ.Socket socket = context.createSocket(SocketType.REP);
    if (!socket.bind("tcp://" + HOST + ":*")) { // a free port
      throw new IOException("JeroMQ finds no free port on " + HOST + ": error " + socket.errno());
    }
    String address = socket.getLastEndpoint();
    Thread server = new Thread(() -> answer(socket), "jeromq-server");
    server.setDaemon(true);
    server.start();
    return address;
  }

  private static void answer(ZMQ.Socket socket) {
    EchoServer served = new EchoServer();
    while (!Thread.currentThread().isInterrupted()) {
      ByteBuffer request = ByteBuffer.wrap(socket.recv());
      ByteBuffer answer;
      if (request.get() == ECHO) {
        answer = ByteBuffer.allocate(Long.BYTES).putLong(served.echo(request.getLong()));
      } else {
        double[] values = served.values();
        answer = ByteBuffer.allocate(values.length * Double.BYTES);
        answer.asDoubleBuffer().put(values);
      }
      socket.send(answer.array());
    }
  }

  @Override
  public Connection connect(String address) {
    ZContext context = new ZContext();
    return () -> {
      ZMQ.Socket socket = context.createSocket(SocketType.REQ);
      socket.setReceiveTimeOut(PATIENCE_MILLIS);
      if (!socket.connect(address)) {
        throw new IOException("JeroMQ cannot connect to " + address + ": error " + socket.errno());
      }
      return new SocketCaller(socket);
    };
  }

  private record SocketCaller(ZMQ.Socket socket) implements Caller {

    @Override
    public long echo(long value) throws IOException {
      byte[] request = ByteBuffer.allocate(1 + Long.BYTES).put(ECHO).putLong(value).array();
      return ByteBuffer.wrap(call(request)).getLong();
    }

    @Override
    public double[] values() throws IOException {
      ByteBuffer answer = ByteBuffer.wrap(call(new byte[] {VALUES}));
      double[] values = new double[answer.remaining() / Double.BYTES];
      answer.asDoubleBuffer().get(values);
      return values;
    }

    private byte[] call(byte[] request) throws IOException {
      boolean isSent = socket.send(request);
      byte @Nullable [] answer = isSent ? socket.recv() : null;
      if (answer == null) {
        throw new IOException(
            "JeroMQ has no answer after " + PATIENCE_MILLIS + " ms: error " + socket.errno());
      }
      return answer;
    }

    @Override
    public void close() {
      socket.close();
    }
  }
}

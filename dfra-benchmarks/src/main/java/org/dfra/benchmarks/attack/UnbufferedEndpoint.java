package org.dfra.benchmarks.attack;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.util.Collection;
import java.util.NoSuchElementException;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.jeri.Endpoint;
import net.jini.jeri.OutboundRequest;
import net.jini.jeri.OutboundRequestIterator;
import org.jspecify.annotations.Nullable;

/**
 * DFRA's transport as an attacker speaks it: bytes are sent at each flush, and each request has a
 * connection that nobody else uses. Written from the description of the format in {@code
 * docs/reference/transport.md}, so that it also tests that.
 *
 * @param host the server's address
 * @param port its TCP port
 * @param source address to connect from; null for that which the system chooses
 */
record UnbufferedEndpoint(String host, int port, @Nullable String source) implements Endpoint {

  private static final int MAGIC = 0x44465241; // "DFRA"
  private static final int VERSION = 1;
  private static final int WELCOME = 0;
  private static final int PART = 0;
  private static final int END = 1;
  private static final int MAX_BYTES = 16 * 1024 - 4;
  private static final int LENGTH_BITS = 24;

  @Override
  public OutboundRequestIterator newRequest(InvocationConstraints constraints) {
    return new OutboundRequestIterator() {
      private boolean isFirst = true;

      @Override
      public boolean hasNext() {
        return isFirst;
      }

      @Override
      public OutboundRequest next() throws IOException {
        if (!isFirst) {
          throw new NoSuchElementException();
        }
        isFirst = false;
        return new Request(connect());
      }
    };
  }

  private Socket connect() throws IOException {
    Socket socket = new Socket();
    try {
      socket.setTcpNoDelay(true);
      if (source != null) {
        socket.bind(new InetSocketAddress(InetAddress.getByName(source), 0));
      }
      socket.connect(new InetSocketAddress(host, port));
      DataOutputStream out = new DataOutputStream(socket.getOutputStream());
      ByteArrayOutputStream greeting = new ByteArrayOutputStream();
      DataOutputStream fields = new DataOutputStream(greeting);
      fields.writeInt(MAGIC);
      fields.writeInt(VERSION << LENGTH_BITS);
      fields.writeLong(0); // any server
      fields.writeLong(0);
      out.write(greeting.toByteArray());
      DataInputStream in = new DataInputStream(socket.getInputStream());
      int magic = in.readInt();
      int version = in.readByte();
      int answer = in.readByte();
      int unused = in.readShort();
      if (magic != MAGIC || version != VERSION || answer != WELCOME) {
        throw new IOException("the server refuses the connection: answer " + answer);
      }
      return socket;
    } catch (IOException e) {
      socket.close();
      throw e;
    }
  }

  /** One request. */
  private static final class Request implements OutboundRequest {

    private final Socket socket;
    private final OutputStream request = new Blocks();
    private final InputStream response = new Response();

    Request(Socket socket) {
      this.socket = socket;
    }

    @Override
    public OutputStream getRequestOutputStream() {
      return request;
    }

    @Override
    public InputStream getResponseInputStream() {
      return response;
    }

    @Override
    public void abort() {
      try {
        socket.close();
      } catch (IOException e) {
        throw new IllegalStateException("a socket cannot be closed", e);
      }
    }

    @Override
    public boolean getDeliveryStatus() {
      return true;
    }

    @Override
    @SuppressWarnings("rawtypes") // as River declares it
    public void populateContext(Collection context) {}

    @Override
    public InvocationConstraints getUnfulfilledConstraints() {
      return InvocationConstraints.EMPTY;
    }

    private final class Blocks extends OutputStream {

      private final ByteArrayOutputStream waiting = new ByteArrayOutputStream();
      private boolean isComplete;

      @Override
      public void write(int b) throws IOException {
        waiting.write(b);
        if (waiting.size() == MAX_BYTES) {
          send(PART);
        }
      }

      @Override
      public void flush() throws IOException {
        if (waiting.size() > 0) {
          send(PART);
        }
      }

      @Override
      public void close() throws IOException {
        if (!isComplete) {
          isComplete = true;
          send(END);
        }
      }

      private void send(int kind) throws IOException {
        ByteArrayOutputStream block = new ByteArrayOutputStream();
        new DataOutputStream(block).writeInt(kind << LENGTH_BITS | waiting.size());
        waiting.writeTo(block);
        waiting.reset();
        socket.getOutputStream().write(block.toByteArray());
      }
    }

    private final class Response extends InputStream {

      private int left;
      private boolean isLast;

      @Override
      public int read() throws IOException {
        while (left == 0) {
          if (isLast) {
            return -1;
          }
          int header = new DataInputStream(socket.getInputStream()).readInt();
          left = header & ((1 << LENGTH_BITS) - 1);
          int kind = header >>> LENGTH_BITS;
          isLast = kind == END;
          if (kind != PART && kind != END) {
            throw new IOException("the server ends the connection");
          }
        }
        int b = socket.getInputStream().read();
        if (b < 0) {
          throw new EOFException("the response ends in a block");
        }
        left--;
        return b;
      }

      @Override
      public void close() {
        abort();
      }
    }
  }
}

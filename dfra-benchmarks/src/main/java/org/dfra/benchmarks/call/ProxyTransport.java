package org.dfra.benchmarks.call;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.nio.file.Path;
import java.rmi.Remote;
import java.util.Base64;
import org.jspecify.annotations.Nullable;

/**
 * Calls through a proxy, which the client's process receives from the server's process as a
 * serialized object. All threads of a client share it.
 */
final class ProxyTransport implements CallTransport {

  private final Preparation preparation;
  private final Export export;

  // Else the garbage collector takes the object.
  private @Nullable Remote exported;

  /** Prepares a process. */
  @FunctionalInterface
  interface Preparation {

    /** Called before anything else. */
    void run() throws IOException;
  }

  /** Exports an object. */
  @FunctionalInterface
  interface Export {

    /**
     * Exports on the loopback.
     *
     * @param served the object
     * @param folder an empty folder for files of the server
     * @return its serializable proxy
     */
    Remote export(Remote served, Path folder) throws IOException;
  }

  /**
   * @param preparation of each process, before it reads an object
   */
  ProxyTransport(Preparation preparation, Export export) {
    this.preparation = preparation;
    this.export = export;
  }

  @Override
  public void prepare() throws IOException {
    preparation.run();
  }

  @Override
  public String serve(Path folder) throws IOException {
    exported = new EchoServer();
    Remote proxy = export.export(exported, folder);
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(proxy);
    }
    return Base64.getEncoder().encodeToString(bytes.toByteArray());
  }

  @Override
  public Connection connect(String address) throws IOException {
    EchoService proxy = read(address);
    Caller caller =
        new Caller() {
          @Override
          public long echo(long value) throws IOException {
            return proxy.echo(value);
          }

          @Override
          public double[] values() throws IOException {
            return proxy.values();
          }
        };
    return () -> caller;
  }

  private static EchoService read(String address) throws IOException {
    byte[] bytes = Base64.getDecoder().decode(address);
    try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes))) {
      return (EchoService) in.readObject();
    } catch (ClassNotFoundException e) {
      throw new IOException("a class of the proxy is not on the class path of the client", e);
    }
  }
}

package org.dfra.river.call;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.lang.reflect.Proxy;
import java.net.BindException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import java.rmi.server.ExportException;
import java.time.Duration;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.export.Exporter;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicILFactory;
import net.jini.jeri.BasicInvocationHandler;
import net.jini.jeri.BasicJeriExporter;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.Endpoint;
import net.jini.jeri.InvocationLayerFactory;
import net.jini.jeri.OutboundRequest;
import net.jini.jeri.ServerEndpoint;
import org.dfra.core.host.FreePorts;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** JERI's object for distributed garbage collection, which passes filters and guards by. */
class DistributedGcTest {

  private static final Uuid COLLECTOR = UuidFactory.create("d32cd1bc-273c-11b2-8841-080020c9e4a1");
  private static final int NO_SUCH_OBJECT = 0;

  /** What is served here. */
  public interface Service extends Remote {
    String echo(String text) throws RemoteException;
  }

  private final Service impl = text -> text; // JERI holds it weakly

  private static BasicJeriExporter collecting(
      ServerEndpoint endpoint, InvocationLayerFactory factory) {
    return new BasicJeriExporter(endpoint, factory, true, true);
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void anExporterWithItIsRefusedAlsoBehindAnother(boolean isRivers) throws Exception {
    int port = FreePorts.allocate();
    ServerEndpoint endpoint =
        isRivers ? Endpoints.river("127.0.0.1", port) : Endpoints.tcp("127.0.0.1", port);
    BasicJeriExporter exporter = collecting(endpoint, new DeadlineILFactory());
    Exporter hidden =
        new Exporter() {
          @Override
          public Remote export(Remote exported) throws ExportException {
            return exporter.export(exported);
          }

          @Override
          public boolean unexport(boolean force) {
            return exporter.unexport(force);
          }
        };
    assertThatThrownBy(() -> hidden.export(impl))
        .isInstanceOf(ExportException.class)
        .hasMessageStartingWith("the exporter of " + impl.getClass().getName())
        .hasMessageEndingWith(
            " uses distributed garbage collection, whose calls no filter checks and no guard"
                + " authorizes; give BasicJeriExporter false as its third argument, or none");
    // River's port is free when the thread that accepted connections has noticed that it is closed.
    await("the port is free again").atMost(Duration.ofSeconds(20)).until(() -> isFree(port));
  }

  private static boolean isFree(int port) throws IOException {
    try (ServerSocket again = new ServerSocket(port, 1, InetAddress.getByName("127.0.0.1"))) {
      return again.isBound();
    } catch (BindException e) {
      return false;
    }
  }

  @Test
  void aConfiguredExporterWithItIsNamed() {
    BasicJeriExporter exporter = collecting(Endpoints.tcp("127.0.0.1", 0), new BasicILFactory());
    assertThatIllegalArgumentException()
        .isThrownBy(() -> JeriExporters.requireNoDistributedGc(exporter, "x.serverExporter"))
        .withMessageStartingWith("x.serverExporter uses distributed garbage collection");
    ActivationID id = new ActivationID(null);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new ResurrectingExporter(id, exporter))
        .withMessageStartingWith("the underlying exporter uses distributed");
  }

  @Test
  void callsToItAreAnsweredThatThereIsNone() throws Exception {
    BasicJeriExporter exporter = collecting(Endpoints.tcp("127.0.0.1", 0), new BasicILFactory());
    Service service = (Service) exporter.export(impl);
    BasicObjectEndpoint its =
        (BasicObjectEndpoint)
            ((BasicInvocationHandler) Proxy.getInvocationHandler(service)).getObjectEndpoint();
    Endpoint endpoint = its.getEndpoint();
    try {
      assertThat(service.echo("before")).isEqualTo("before");
      assertThat(answer(endpoint, COLLECTOR)).isEqualTo(NO_SUCH_OBJECT);
      assertThat(service.echo("after")).isEqualTo("after");
    } finally {
      exporter.unexport(true);
    }
  }

  /** The first byte of JERI's answer to a request that consists of an object's ID only. */
  private static int answer(Endpoint endpoint, Uuid object) throws IOException {
    OutboundRequest request = endpoint.newRequest(InvocationConstraints.EMPTY).next();
    ByteArrayOutputStream id = new ByteArrayOutputStream();
    object.write(id);
    try (OutputStream out = request.getRequestOutputStream()) {
      out.write(id.toByteArray());
    }
    try (InputStream in = request.getResponseInputStream()) {
      return in.read();
    }
  }
}

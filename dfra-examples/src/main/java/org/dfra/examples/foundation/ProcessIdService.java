package org.dfra.examples.foundation;

import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import net.jini.export.ProxyAccessor;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.module.Idempotent;
import org.dfra.river.call.ResurrectingExporter;
import org.dfra.river.server.Exporters;

/**
 * The smallest activatable object: it needs no device, so that it shows the cost of activation
 * itself.
 */
public interface ProcessIdService extends Remote {

  /** The ID of the process that the service runs in. */
  @Idempotent
  long pid() throws RemoteException;

  /** The server of the PID service. */
  final class Server implements ProcessIdService, ProxyAccessor {

    private static final long DEADLINE_MILLIS = 2000;

    private final Remote proxy;

    /** Called by the activation system. */
    public Server(ActivationID id, MarshalledObject<?> none) throws RemoteException {
      proxy =
          new ResurrectingExporter(id, Exporters.jeri(DemoEnvironment.ADDRESS, DEADLINE_MILLIS))
              .export(this);
    }

    @Override
    public long pid() {
      return ProcessHandle.current().pid();
    }

    @Override
    public Object getProxy() {
      return proxy;
    }
  }
}

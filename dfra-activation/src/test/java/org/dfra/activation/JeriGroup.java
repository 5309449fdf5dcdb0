package org.dfra.activation;

import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.activation.ActivationInstantiator;
import net.jini.activation.ActivationGroup;
import net.jini.export.Exporter;
import net.jini.jeri.BasicILFactory;
import net.jini.jeri.BasicJeriExporter;
import net.jini.jeri.tcp.TcpServerEndpoint;

/** A group as River's daemon has them: exported by JERI, and replaced by its proxy when written. */
public final class JeriGroup extends ActivationGroup {

  private static final long serialVersionUID = 1L;

  private final transient Exporter exporter =
      new BasicJeriExporter(
          TcpServerEndpoint.getInstance("127.0.0.1", 0, null, new JeriExportMain.OnLoopback()),
          new BasicILFactory());
  private final transient Remote proxy;

  public JeriGroup(ActivationGroupID id, MarshalledObject<?> data) throws RemoteException {
    super(id);
    unexportObject(this, true);
    proxy = exporter.export(this);
  }

  private Object writeReplace() {
    return proxy;
  }

  ActivationInstantiator proxy() {
    return (ActivationInstantiator) proxy;
  }

  void end() throws RemoteException, java.rmi.activation.UnknownGroupException {
    exporter.unexport(true);
    inactiveGroup();
  }

  @Override
  public MarshalledObject<? extends Remote> newInstance(ActivationID id, ActivationDesc desc) {
    return null;
  }

  @Override
  public void activeObject(ActivationID id, Remote obj) {}

  @Override
  public boolean inactiveObject(ActivationID id, Exporter ofObject) {
    return ofObject.unexport(false);
  }
}

package org.dfra.activation;

import java.io.Closeable;
import java.io.IOException;
import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroup;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.activation.UnknownGroupException;

/** The smallest group: it constructs nothing, but says what it was asked for. */
public final class PlainGroup extends ActivationGroup {

  private static final long serialVersionUID = 1L;

  /** The group constructed last, whether or not the system took it. */
  static PlainGroup last;

  final MarshalledObject<?> given;

  public PlainGroup(ActivationGroupID id, MarshalledObject<?> data) throws RemoteException {
    super(id);
    given = data;
    last = this;
  }

  @Override
  public MarshalledObject<? extends Remote> newInstance(ActivationID id, ActivationDesc desc)
      throws ActivationException {
    throw new ActivationException("asked for a " + desc.getClassName());
  }

  @Override
  public void activeObject(ActivationID id, Remote obj)
      throws ActivationException, RemoteException {
    try {
      activeObject(id, new MarshalledObject<>(obj));
    } catch (RemoteException e) {
      throw e;
    } catch (IOException e) {
      throw new ActivationException("cannot be marshalled", e);
    }
  }

  void end() throws UnknownGroupException, RemoteException {
    inactiveGroup();
  }

  /** No constructor a group needs. */
  public abstract static class WithoutConstructor extends ActivationGroup {
    WithoutConstructor() throws RemoteException {
      super(null);
    }
  }

  /** The constructor, but abstract. */
  public abstract static class Abstract extends ActivationGroup {
    public Abstract(ActivationGroupID id, MarshalledObject<?> data) throws RemoteException {
      super(id);
    }
  }

  /** What the two below share. */
  public abstract static class Base extends ActivationGroup {
    Base(ActivationGroupID id) throws RemoteException {
      super(id);
    }

    @Override
    public MarshalledObject<? extends Remote> newInstance(ActivationID id, ActivationDesc desc) {
      return null;
    }

    @Override
    public void activeObject(ActivationID id, Remote obj) {}
  }

  /** A constructor that fails after the export. */
  public static final class Failing extends Base {
    public Failing(ActivationGroupID id, MarshalledObject<?> data) throws RemoteException {
      super(id);
      unexportObject(this, true);
      throw new RemoteException("no lock file");
    }
  }

  /** A constructor that fails after the export and leaves it behind. */
  public static final class FailingLate extends Base {

    /** The group constructed last, as far as it was. */
    static ActivationGroup failed;

    public FailingLate(ActivationGroupID id, MarshalledObject<?> data) throws RemoteException {
      super(id);
      failed = this;
      throw new RemoteException("no configuration");
    }
  }

  /** A group that has something to close, which fails. */
  public static final class Closing extends Base implements Closeable {

    static int closed;

    public Closing(ActivationGroupID id, MarshalledObject<?> data) throws RemoteException {
      super(id);
    }

    @Override
    public void close() throws IOException {
      closed++;
      throw new IOException("half closed");
    }
  }

  /** The constructor, but in a class only its package sees. */
  static final class Hidden extends Base {
    public Hidden(ActivationGroupID id, MarshalledObject<?> data) throws RemoteException {
      super(id);
    }
  }
}

package org.dfra.slice;

import static org.assertj.core.api.Assertions.catchThrowable;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.rmi.NoSuchObjectException;
import java.rmi.Remote;
import java.rmi.server.ExportException;
import java.util.UUID;
import net.jini.export.Exporter;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.SensorImpl;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Identification;
import org.dfra.module.Module;
import org.dfra.river.proxy.sensor.SensorProxy;
import org.dfra.river.remote.RemoteModule;
import org.dfra.river.server.Exporters;
import org.dfra.river.server.Exporters.ServerSettings;

/**
 * What a thermometer may be made of: drivers and a proxy with a fault each, and a driver and an
 * exporter that are watched. Public, so that a description and a Jini configuration can name them.
 */
public final class FaultyThermometers {

  private FaultyThermometers() {}

  /** Base of the drivers here. */
  abstract static class RoomImpl extends SensorImpl implements Thermometer {

    RoomImpl(ModuleContext context) {
      super(context, "test thermometer", "DFRA", "1");
    }

    @Override
    protected void onStart() {
      transitionTo(Readiness.READY);
    }

    @Override
    protected void onClose() {}

    @Override
    public double updateRate() {
      return 0;
    }

    @Override
    public double celsius() {
      return 20;
    }
  }

  /** Holds a thread and a port from start to close. */
  public static class WatchedImpl extends RoomImpl {

    static WatchedImpl last;

    ServerSocket port;
    Thread thread;

    public WatchedImpl(ModuleContext context) {
      super(context);
      last = this;
    }

    @Override
    protected void onStart() {
      try {
        port = new ServerSocket(0, 0, InetAddress.getByName("127.0.0.1"));
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
      thread = new Thread(() -> catchThrowable(port::accept), "watched driver");
      thread.start();
      super.onStart();
    }

    @Override
    protected void onClose() {
      try {
        port.close();
        thread.join();
      } catch (IOException | InterruptedException e) {
        throw new IllegalStateException(e);
      }
    }

    boolean isWorking() {
      return thread.isAlive() && !port.isClosed();
    }

    void connect() throws IOException {
      new Socket(port.getInetAddress(), port.getLocalPort()).close();
    }
  }

  /** Starts, and then finds that it cannot work. */
  public static final class StubbornImpl extends WatchedImpl {
    public StubbornImpl(ModuleContext context) {
      super(context);
    }

    @Override
    protected void onStart() {
      super.onStart();
      throw new IllegalStateException("the mast is up");
    }
  }

  /** Not for everybody. */
  public static final class ShyImpl extends RoomImpl {
    ShyImpl(ModuleContext context) {
      super(context);
    }
  }

  /** Only an idea. */
  public abstract static class IdeaImpl extends RoomImpl {
    public IdeaImpl(ModuleContext context) {
      super(context);
    }
  }

  /** Has a fault. */
  public static final class BrokenImpl extends RoomImpl {
    public BrokenImpl(ModuleContext context) {
      super(context);
      throw new ArithmeticException("/ by zero");
    }
  }

  /** Needs a library that is not there. */
  public static final class LinklessImpl extends RoomImpl {
    public LinklessImpl(ModuleContext context) {
      super(context);
      throw new NoClassDefFoundError("com/acme/Port");
    }
  }

  /** Needs a parameter and is particular about it. */
  public static final class ChoosyImpl extends RoomImpl {
    public ChoosyImpl(ModuleContext context) {
      super(context);
      if (!settings().text("room").equals("kitchen")) {
        throw settings().fault("room", "a room with a window", null);
      }
    }
  }

  /** Not for everybody either. */
  public static final class ShyProxy extends SensorProxy<Thermometer> implements Thermometer {
    private static final long serialVersionUID = 1L;

    ShyProxy(RemoteModule server, UUID id, Identification identification) {
      super(Thermometer.class, server, id, identification);
    }

    @Override
    public double celsius() throws java.rmi.RemoteException {
      return target().celsius();
    }
  }

  /** The usual exporter, watched. */
  public static final class WatchedExporter implements Exporter {

    static WatchedExporter last;

    private final Exporter usual;
    private Remote proxy;

    public WatchedExporter(ServerSettings settings) {
      usual = Exporters.jeri(settings, 2000);
      last = this;
    }

    @Override
    public Remote export(Remote impl) throws ExportException {
      proxy = usual.export(impl);
      return proxy;
    }

    @Override
    public boolean unexport(boolean force) {
      return usual.unexport(force);
    }

    boolean isExported() {
      if (proxy == null) {
        return false;
      }
      try {
        return ((Module) proxy).readiness() != null;
      } catch (NoSuchObjectException | java.rmi.ConnectException e) {
        return false;
      } catch (java.rmi.RemoteException e) {
        throw new UncheckedIOException(e);
      }
    }
  }
}

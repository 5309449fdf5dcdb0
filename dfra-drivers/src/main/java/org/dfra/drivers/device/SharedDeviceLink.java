package org.dfra.drivers.device;

import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.Ticker;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A link to a device, shared by the modules of a virtual machine that name the same link, because a
 * serial port can have only one owner. It is opened for the first module that joins, and closed
 * when the last one leaves. A protocol extends this class and keeps its links in a {@link
 * SharedLinkRegistry}; a module joins and leaves through a {@link SharedLinkHandle}.
 *
 * <p>Threads: one reader, owned from the first module to the last; it notifies the clients.
 *
 * @param <M> interface through which the protocol notifies and queries its clients
 */
public abstract class SharedDeviceLink<M extends SharedLinkClient> {

  /** Log for the events of the link. */
  protected final Logger log;

  private final SharedLinkRegistry<M, ?> registry;
  private final String name;
  private final ModuleContext context;
  private final SharedLinkClients<M> clients = new SharedLinkClients<>();

  /**
   * @param registry the registry that keeps the link
   * @param name name of the protocol; the reader is called {@code name reader}
   * @param context context of the first module that joins
   */
  protected SharedDeviceLink(
      SharedLinkRegistry<M, ?> registry, String name, ModuleContext context) {
    this.registry = registry;
    this.name = name;
    this.context = context;
    this.log = LoggerFactory.getLogger("dfra." + context.robot() + "." + name);
  }

  /** Makes the link for a protocol from the parameters of the first module; not started. */
  protected final DeviceLink newDeviceLink(
      DeviceProtocol protocol, Ticker ticker, LinkKeeper.@Nullable Source source) {
    ModuleContext shared =
        new ModuleContext(context.robot(), name, context.parameters(), context.clock());
    return new DeviceLink(shared, protocol, ticker, source, log);
  }

  /** The link itself, for diagnostics. */
  public abstract DeviceLink deviceLink();

  /** The modules that share it. */
  protected final SharedLinkClients<M> clients() {
    return clients;
  }

  /** The path of the module that joined first, whose parameters apply. */
  protected final String firstClientPath() {
    return context.path();
  }

  /** A module has joined: opens the link if that was the first. */
  protected void start() {
    deviceLink().start();
  }

  /** The last module has left. */
  protected void close() {
    deviceLink().close();
  }

  /** Leaves; returns when the client will receive no more notifications. */
  final void leave(M client) {
    registry.leave(client, this);
  }
}

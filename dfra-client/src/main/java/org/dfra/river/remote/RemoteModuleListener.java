package org.dfra.river.remote;

import java.rmi.Remote;
import org.dfra.event.ModuleListener;

/** A listener that is notified over the network. Clients need not implement it: proxies do. */
public interface RemoteModuleListener extends ModuleListener, Remote {}

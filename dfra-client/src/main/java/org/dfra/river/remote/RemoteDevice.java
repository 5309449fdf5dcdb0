package org.dfra.river.remote;

import org.dfra.flow.Device;

/** What clients may call on any device's server. */
public interface RemoteDevice extends RemoteModule, RemoteDiagnostics, Device {}

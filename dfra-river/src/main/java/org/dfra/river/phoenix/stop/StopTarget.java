package org.dfra.river.phoenix.stop;

import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.flow.effector.EmergencyStopState;
import org.jspecify.annotations.Nullable;

/** An activatable object that phoenix can stop: the server of an effector. */
public interface StopTarget {

  /** The module's identity, its service ID in every lookup service. */
  UUID moduleId();

  /** The module's path, {@code robot/name}. */
  String modulePath();

  /** See {@link org.dfra.flow.effector.Effector#emergencyStopState}. */
  EmergencyStopState emergencyStopState() throws RemoteException;

  /** See {@link org.dfra.flow.effector.Effector#emergencyStop}. */
  EmergencyStopState emergencyStop(@Nullable String by) throws RemoteException;
}

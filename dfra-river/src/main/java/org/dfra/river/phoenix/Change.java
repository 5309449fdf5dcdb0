package org.dfra.river.phoenix;

import java.io.Serializable;
import java.rmi.MarshalledObject;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationInstantiator;
import java.rmi.server.UID;

/** One entry of the journal: what was changed in the registrations. */
sealed interface Change extends Serializable {

  /** A group was registered under a name of the daemon's making. */
  record GroupRegistered(ActivationGroupID group, String name, ActivationGroupDesc desc)
      implements Change {}

  /** A group got another descriptor. */
  record GroupDescribed(ActivationGroupID group, ActivationGroupDesc desc) implements Change {}

  /** A group, with its objects, got another identity: phoenix came back at another address. */
  record GroupMoved(ActivationGroupID group, ActivationGroupID to) implements Change {}

  /** A group and its objects were forgotten. */
  record GroupUnregistered(ActivationGroupID group) implements Change {}

  /** A process is about to be started for the group. Written before it is. */
  record Launching(ActivationGroupID group, long incarnation) implements Change {}

  /** The process was started. Written before it is told which group it is. */
  record Launched(ActivationGroupID group, ProcessIdentity process) implements Change {}

  /** The process reported that it makes objects. Written before its report is answered. */
  record Reported(ActivationGroupID group, MarshalledObject<ActivationInstantiator> instantiator)
      implements Change {}

  /** The group said that it makes no more objects. */
  record Left(ActivationGroupID group) implements Change {}

  /** An object was registered. */
  record ObjectRegistered(UID object, ActivationDesc desc) implements Change {}

  /** An object got another descriptor, in the same group. */
  record ObjectDescribed(UID object, ActivationDesc desc) implements Change {}

  /**
   * An object was forgotten.
   *
   * @param incarnation of its group's process, where that may still have the object; else 0
   */
  record ObjectUnregistered(UID object, long incarnation) implements Change {}

  /** An object that was forgotten while a process had it has become inactive there. */
  record UnregisteredEnded(ActivationGroupID group, UID object) implements Change {}
}

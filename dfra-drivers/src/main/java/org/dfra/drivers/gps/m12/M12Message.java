package org.dfra.drivers.gps.m12;

/** A message from a receiver, decoded from one intact frame. */
public sealed interface M12Message
    permits M12PositionMessage,
        VisibleSatellites,
        TimeRaim,
        PositionControl,
        PositionHoldMode,
        HeldPosition,
        ReceiverClock,
        M12UtcOffset,
        TimeScale,
        ReceiverIdentification,
        OtherMessage,
        MalformedMessage {

  /** The frame's ID: two letters, such as {@code Ha}. */
  String id();
}

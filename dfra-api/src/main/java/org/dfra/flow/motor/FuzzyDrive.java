package org.dfra.flow.motor;

import java.rmi.RemoteException;
import org.dfra.flow.perceptual.Clearance;
import org.dfra.flow.perceptual.HeadingPercept;
import org.dfra.module.Idempotent;

/** Drives towards a heading and around what is in the way, by the rules of a fuzzy system. */
public interface FuzzyDrive extends MotorSchema {

  /** What the wheels should do, the room and the heading being so. */
  @Idempotent
  DriveAdvice advise(Clearance clearance, HeadingPercept heading) throws RemoteException;
}

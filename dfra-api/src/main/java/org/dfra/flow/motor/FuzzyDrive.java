package org.dfra.flow.motor;

import java.rmi.RemoteException;
import org.dfra.flow.perceptual.Clearance;
import org.dfra.flow.perceptual.HeadingPercept;
import org.dfra.module.Idempotent;

/** Drives towards a heading and around obstacles, by the rules of a fuzzy system. */
public interface FuzzyDrive extends MotorSchema {

  /** The recommended velocity for the current clearance and heading error. */
  @Idempotent
  DriveAdvice advise(Clearance clearance, HeadingPercept heading) throws RemoteException;
}

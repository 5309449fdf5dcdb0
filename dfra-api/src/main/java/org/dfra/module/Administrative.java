package org.dfra.module;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * A method that changes a module for everybody who uses it: its parameters, its log level, its
 * connections to other modules, other clients' leases, its end, the release of an emergency stop.
 *
 * <p>A remote call of such a method is served only if it comes from the robot's own computer or
 * from an address that the robot's XML names in {@code <administration from="…">}. All others get
 * an {@link AdministrationRefusedException}. Setting an emergency stop is never administrative:
 * anybody may stop a robot. A command goes by its lease and is not administrative either.
 *
 * <p>The mark counts where it stands on any interface of the remote object that declares the
 * method. A class that lacks this annotation's class still works: Java then ignores the mark.
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.METHOD)
public @interface Administrative {}

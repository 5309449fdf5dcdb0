package org.dfra.module;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * A method that changes a module for all its clients: its parameters, its log level, its
 * connections to other modules, other clients' leases, its end, the release of an emergency stop.
 *
 * <p>A remote call of such a method is served only if it comes from the robot's own computer or
 * from an address that the robot's XML names in {@code <administration from="…">}. All others
 * receive an {@link AdministrationRefusedException}. Setting an emergency stop is never
 * administrative: any client may stop a robot. A command is authorized by its lease and is not
 * administrative either.
 *
 * <p>The annotation is effective on any interface of the remote object that declares the method. A
 * client without this annotation's class still works: Java then ignores the annotation.
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.METHOD)
public @interface Administrative {}
